package rigibo.frontend.document;

/**
 * What stands for schemas in the page, whose library no browser runs: levels of the game are held
 * against theirs when the page is built, and the rules after it apply to all.
 */
public final class JsonSchema {

    /** Any schema. */
    public JsonSchema(String resource) {}

    /** Whether a document can be looked at any further. */
    public boolean admits(Document document) {
        return document.root().isObject();
    }
}
