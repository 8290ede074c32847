package tools.jackson.core;

/** The parts of a JSON text. */
public enum JsonToken {
    NOT_AVAILABLE,
    START_OBJECT,
    END_OBJECT,
    START_ARRAY,
    END_ARRAY,
    PROPERTY_NAME,
    VALUE_EMBEDDED_OBJECT,
    VALUE_STRING,
    VALUE_NUMBER_INT,
    VALUE_NUMBER_FLOAT,
    VALUE_TRUE,
    VALUE_FALSE,
    VALUE_NULL
}
