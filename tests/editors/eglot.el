;;; eglot.el --- Opens each file that is given, and prints what the server told of it  -*- lexical-binding: t -*-
(require 'package)
(package-initialize)
(require 'eglot)
(require 'json)
(require 'cl-lib)

(define-derived-mode cncsub-nc-mode prog-mode "NC")
(let ((server (append (json-parse-string (getenv "CNCSUB_SERVER")) nil)))
  (add-to-list 'eglot-server-programs (cons 'cncsub-nc-mode server)))
(setq eglot-sync-connect 30
      eglot-autoshutdown t
      eglot-events-buffer-size 0)

;; The folder of the job is the project.
(defun cncsub-project (_folder)
  (cons 'transient (file-name-as-directory (getenv "CNCSUB_ROOT"))))
(setq project-find-functions (list #'cncsub-project))

(defvar cncsub-published (make-hash-table :test #'equal)
  "The diagnostics that the server told, by file.")
(cl-defmethod eglot-handle-notification :before
  (_server (_method (eql textDocument/publishDiagnostics))
           &key uri diagnostics &allow-other-keys)
  (puthash (file-truename (eglot--uri-to-path uri)) diagnostics cncsub-published))

(defun cncsub-diagnostic (told)
  (let ((start (plist-get (plist-get told :range) :start)))
    (list :line (plist-get start :line)
          :column (plist-get start :character)
          :code (plist-get told :code))))

(defun cncsub-ask (asked)
  "Open the file of ASKED, and return what the server tells of its place."
  (let ((file (gethash "file" asked)))
    (find-file file)
    (cncsub-nc-mode)
    (eglot-ensure)
    (run-hooks 'post-command-hook)
    (unless (eglot-managed-p)
      (eglot--maybe-activate-editing-mode))
    (let ((end (+ (float-time) 30))
          (key (file-truename file)))
      (while (and (not (gethash key cncsub-published)) (< (float-time) end))
        (accept-process-output nil 0.05))
      (goto-char (point-min))
      (forward-line (gethash "line" asked))
      (forward-char (min (gethash "column" asked) (- (line-end-position) (point))))
      (let* ((server (eglot--current-server-or-lose))
             (here (eglot--TextDocumentPositionParams))
             (hover (jsonrpc-request server :textDocument/hover here))
             (definition (jsonrpc-request server :textDocument/definition here))
             (document (plist-get here :textDocument))
             ;; A change that is refused comes back as an error.
             (rename (ignore-errors
                       (jsonrpc-request server :textDocument/rename
                                        (append here (list :newName "77")))))
             (format (jsonrpc-request server :textDocument/formatting
                                      (list :textDocument document
                                            :options '(:tabSize 2 :insertSpaces t))))
             (symbols (jsonrpc-request server :textDocument/documentSymbol
                                       (list :textDocument document))))
        (list :file file
              :published (if (gethash key cncsub-published) t :json-false)
              :diagnostics (vconcat (mapcar #'cncsub-diagnostic (gethash key cncsub-published)))
              :definition (or definition [])
              :rename rename
              :format (or format [])
              :symbols (or symbols [])
              :hover (if hover (plist-get (plist-get hover :contents) :value) ""))))))

(princ (json-encode
        (vconcat (mapcar #'cncsub-ask (json-parse-string (getenv "CNCSUB_ASKED"))))))
(terpri)
