
#error "constants are in the code: change the document and generate again, or use parameters"
