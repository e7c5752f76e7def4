;;; kindsl-mode.el --- Robots in the Kinematics-DSL  -*- lexical-binding: t; -*-

;; Package-Requires: ((emacs "27.1"))
;; Keywords: languages

;;; Commentary:

;; A major mode for `.kindsl' files: colours, comments, indentation in the style of
;; `kindsl format', and an entry for eglot, which `M-x eglot' then starts the language server by.

;;; Code:

(defgroup kindsl nil
  "Robots in the Kinematics-DSL."
  :group 'languages)

(defcustom kindsl-indent-offset 4
  "Columns that what is in a block stands further in."
  :type 'integer
  :safe #'integerp)

(defcustom kindsl-server-command '("kindsl-language-server")
  "The language server and its arguments."
  :type '(repeat string))

(defvar kindsl-mode-syntax-table
  (let ((table (make-syntax-table)))
    (modify-syntax-entry ?/ ". 124b" table)
    (modify-syntax-entry ?* ". 23" table)
    (modify-syntax-entry ?\n "> b" table)
    (modify-syntax-entry ?_ "_" table)
    (modify-syntax-entry ?{ "(}" table)
    (modify-syntax-entry ?} "){" table)
    table))

(defconst kindsl--blocks '("Robot" "RobotBase" "link" "r_joint" "p_joint"))

(defconst kindsl--sections
  '("id" "inertia_params" "inertia_properties" "children" "frames" "ref_frame" "mass" "CoM" "Ix"
    "Iy" "Iz" "Ixy" "Ixz" "Iyz" "translation" "rotation" "floating" "via"))

(defconst kindsl--constants '("PI" "Pi" "pI" "pi"))

(defconst kindsl-font-lock-keywords
  `((,(concat (regexp-opt kindsl--blocks 'symbols) "[ \t]+\\(\\_<[[:alpha:]_][[:alnum:]_]*\\_>\\)")
     (1 font-lock-keyword-face) (2 font-lock-function-name-face))
    (,(regexp-opt kindsl--blocks 'symbols) . font-lock-keyword-face)
    (,(regexp-opt kindsl--sections 'symbols) . font-lock-builtin-face)
    (,(regexp-opt kindsl--constants 'symbols) . font-lock-constant-face)))

(defun kindsl--indentation ()
  "Return the column that the line at point should begin in."
  (save-excursion
    (beginning-of-line)
    (let ((closes (looking-at-p "[ \t]*}"))
          (case-fold-search nil))
      (if (looking-at-p (concat "[ \t]*" (regexp-opt (cdr kindsl--blocks) 'symbols)))
          0
        (let ((opener (nth 1 (syntax-ppss))))
          (if (null opener)
              0
            (goto-char opener)
            (back-to-indentation)
            (if (or closes (looking-at-p "Robot\\_>"))
                (current-column)
              (+ (current-column) kindsl-indent-offset))))))))

(defun kindsl-indent-line ()
  "Indent the line at point in the style of `kindsl format'."
  (interactive)
  (let ((column (kindsl--indentation)))
    (if (<= (current-column) (current-indentation))
        (indent-line-to column)
      (save-excursion (indent-line-to column)))))

;;;###autoload
(define-derived-mode kindsl-mode prog-mode "Kinematics-DSL"
  "Major mode for robots in the Kinematics-DSL."
  (setq-local comment-start "// ")
  (setq-local comment-start-skip "\\(?://+\\|/\\*+\\)[ \t]*")
  (setq-local comment-end "")
  (setq-local indent-tabs-mode nil)
  (setq-local tab-width kindsl-indent-offset)
  (setq-local indent-line-function #'kindsl-indent-line)
  (setq-local electric-indent-chars (append '(?}) electric-indent-chars))
  (setq-local font-lock-defaults '(kindsl-font-lock-keywords)))

;;;###autoload
(add-to-list 'auto-mode-alist '("\\.kindsl\\'" . kindsl-mode))

(put 'kindsl-mode 'eglot-language-id "kinematics-dsl")

(defvar eglot-server-programs)
(declare-function eglot-current-server "eglot")
(declare-function eglot-client-capabilities "eglot")
(declare-function jsonrpc-request "jsonrpc")

(with-eval-after-load 'eglot
  (add-to-list 'eglot-server-programs
               (cons 'kindsl-mode (lambda (&rest _) kindsl-server-command))))

(defun kindsl--uri ()
  "Return the address of the current buffer's file."
  (if (fboundp 'eglot-path-to-uri)
      (funcall 'eglot-path-to-uri buffer-file-name)
    (funcall 'eglot--path-to-uri buffer-file-name)))

(defun kindsl-preview ()
  "Show the robot of this buffer in the browser; return the address."
  (interactive)
  (let ((server (and (fboundp 'eglot-current-server) (eglot-current-server))))
    (unless server
      (user-error "No language server is attached; start it with M-x eglot"))
    (let* ((answer (jsonrpc-request server :workspace/executeCommand
                                    (list :command "kindsl.preview"
                                          :arguments (vector (kindsl--uri)))))
           (window (plist-get (eglot-client-capabilities server) :window))
           (url (plist-get answer :url)))
      (unless (plist-get window :showDocument)
        (browse-url url))
      (message "Preview at %s" url)
      url)))

(provide 'kindsl-mode)

;;; kindsl-mode.el ends here
