;; Attaches to the language server with eglot as docs/editors.md says, then uses it like a hand
;; would.  Prints one line `name: t|nil` a step; ends with an error if one is nil.
(when (< emacs-major-version 29) (package-initialize))
(require 'eglot)
(require 'flymake)
(require 'json)

(define-derived-mode kindsl-mode prog-mode "Kinematics-DSL")
(add-to-list 'auto-mode-alist '("\\.kindsl\\'" . kindsl-mode))
(add-to-list 'eglot-server-programs
             (cons 'kindsl-mode (append (json-read-from-string (getenv "KINDSL_SERVER")) nil)))
(setq eglot-sync-connect 20
      flymake-no-changes-timeout 0.1
      eglot-confirm-server-initiated-edits nil
      make-backup-files nil)

(defvar all-is-well t)

(defun step (name is-well)
  (unless is-well (setq all-is-well nil))
  (princ (format "%s: %s\n" name (and is-well t))))

(defun wait-for (condition)
  (let ((end (+ (float-time) 15)) found)
    (while (and (not (setq found (funcall condition))) (< (float-time) end))
      (accept-process-output nil 0.05)
      (sit-for 0.02))
    found))

(defun errors ()
  (seq-filter (lambda (found) (memq (flymake-diagnostic-type found) '(eglot-error :error)))
              (flymake-diagnostics)))

(defun at (text)
  (goto-char (point-min))
  (search-forward text))

(with-current-buffer (find-file-noselect (getenv "KINDSL_DOCUMENT"))
  (apply #'eglot--connect (eglot--guess-contact))
  (step "attached" (eglot-managed-p))
  (flymake-mode 1)
  (flymake-start)
  (step "diagnostic" (wait-for #'errors))
  (dolist (found (flymake-diagnostics))
    (princ (format "  %d %s\n" (line-number-at-pos (flymake-diagnostic-beg found))
                   (flymake-diagnostic-text found))))
  (at "link ar")
  (let ((hover (jsonrpc-request (eglot--current-server-or-lose) :textDocument/hover
                                (eglot--TextDocumentPositionParams))))
    (step "hover" (string-match-p "arm" (format "%S" hover))))
  (at "children {")
  (let ((offered (jsonrpc-request (eglot--current-server-or-lose) :textDocument/completion
                                  (eglot--TextDocumentPositionParams))))
    (step "completion" (> (length (plist-get offered :items)) 0)))
  (at "link ar")
  (eglot-rename "forearm")
  (step "rename" (and (string-match-p "link forearm" (buffer-string))
                      (string-match-p "forearm via" (buffer-string))))
  (eglot-format-buffer)
  (step "format" (string-match-p "\n    id = 1" (buffer-string)))
  (undo-boundary)
  (eglot--signal-textDocument/didChange)
  (let* ((before (buffer-string))
         (number '(:kind "joint" :name "shoulder" :component "z" :value 0.6))
         (uri (plist-get (eglot--TextDocumentIdentifier) :uri))
         (answer (jsonrpc-request (eglot--current-server-or-lose) :workspace/executeCommand
                                  (list :command "kindsl.setComponent"
                                        :arguments (vector uri number)))))
    (wait-for (lambda () (not (equal before (buffer-string)))))
    (step "set" (and (eq t (plist-get answer :applied))
                     (string-match-p "translation = (0.0, 0.0, 0.6)" (buffer-string))))
    (undo-boundary)
    (undo)
    (step "undone" (equal before (buffer-string))))
  (at "missing via")
  (delete-region (line-beginning-position) (1+ (line-end-position)))
  (eglot--signal-textDocument/didChange)
  (step "cleared" (wait-for (lambda () (null (errors)))))
  (set-buffer-modified-p nil)
  (eglot-shutdown (eglot-current-server))
  (step "stopped" (null (eglot-current-server))))
(kill-emacs (if all-is-well 0 1))
