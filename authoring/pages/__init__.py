"""The pages of the admin besides the forms of rows; `table` lists them."""
