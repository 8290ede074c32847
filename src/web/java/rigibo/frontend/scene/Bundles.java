package rigibo.frontend.scene;

import java.io.IOException;
import java.io.StringReader;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.Enumeration;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Properties;
import java.util.ResourceBundle;

/** Texts by keys, from the properties files of the page. */
public final class Bundles {

    private static final Map<String, ResourceBundle> READ = new HashMap<>();

    private Bundles() {}

    /** The texts in a language; for missing ones, those without a language. */
    public static ResourceBundle of(String name, Locale language) {
        Path place = Path.of(System.getProperty("rigibo.home"), "words");
        Path common = place.resolve(name + ".properties");
        Path own = place.resolve(name + "_" + language.getLanguage() + ".properties");
        return READ.computeIfAbsent(own.toString(), any -> new Texts(common, own));
    }

    /** A language's texts, backed by those without a language. */
    private static final class Texts extends ResourceBundle {

        private static final char MOST_PLAIN = 0xff;

        /** Added to a character, so that all but the first of its hexadecimal digits are four. */
        private static final int ESCAPE = 0x10000;

        private final Properties texts = new Properties();

        Texts(Path... files) {
            try {
                for (Path file : files) {
                    if (Files.exists(file)) {
                        texts.load(new StringReader(escaped(Files.readString(file))));
                    }
                }
            } catch (IOException broken) {
                throw new UncheckedIOException(broken);
            }
        }

        /** Escapes other characters, since TeaVM's {@link Properties} cut them to eight bits. */
        private static String escaped(String text) {
            StringBuilder escaped = new StringBuilder();
            for (char letter : text.toCharArray()) {
                if (letter <= MOST_PLAIN) {
                    escaped.append(letter);
                } else {
                    escaped.append("\\u").append(Integer.toHexString(ESCAPE + letter).substring(1));
                }
            }
            return escaped.toString();
        }

        @Override
        protected Object handleGetObject(String key) {
            return texts.getProperty(key);
        }

        @Override
        public Enumeration<String> getKeys() {
            return Collections.enumeration(texts.stringPropertyNames());
        }
    }
}
