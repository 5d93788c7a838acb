// CW0…: what any part may say.
CAMWRIGHT_CODE(InternalError, "CW0001", Error, CW_TEXT("Diagnostics", "Camwright made a mistake: %1. Save your work under another name and report this text."))
CAMWRIGHT_CODE(Cancelled, "CW0002", Information, CW_TEXT("Diagnostics", "Cancelled. Nothing was changed."))
CAMWRIGHT_CODE(NotAValue, "CW0003", Error, CW_TEXT("Diagnostics", "\"%1\" is not a value of type %2. Write it like %3."))
CAMWRIGHT_CODE(ValueOutOfRange, "CW0004", Error, CW_TEXT("Diagnostics", "%1 is outside the range of %2, which is %3 to %4."))
