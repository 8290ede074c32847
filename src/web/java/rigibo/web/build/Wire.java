package rigibo.web.build;

import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Calls methods of a browser, and passes on what it tells unasked. */
final class Wire {

    private static final Pattern NUMBER =
            Pattern.compile("^\\{(?:\"type\":\"(?:success|error)\",)?\"id\":(\\d+)");

    /** A browser that says nothing for so long is broken. */
    private static final int MOST_SECONDS = 60;

    private final BlockingQueue<String> answers = new LinkedBlockingQueue<>();
    private final Consumer<String> events;
    private final WebSocket socket;
    private int count;

    /** Connects to a browser's address. */
    Wire(String address, Consumer<String> events) {
        this.events = events;
        socket =
                HttpClient.newHttpClient()
                        .newWebSocketBuilder()
                        .buildAsync(URI.create(address), new Listener())
                        .join();
    }

    /** Puts the parts of messages together. */
    private final class Listener implements WebSocket.Listener {

        private final StringBuilder message = new StringBuilder();

        @Override
        public CompletionStage<?> onText(WebSocket from, CharSequence part, boolean isLast) {
            message.append(part);
            if (isLast) {
                answers.add(message.toString());
                message.setLength(0);
            }
            from.request(1);
            return null;
        }
    }

    /** Calls a method with parameters in JSON, without their braces; returns the answer. */
    String send(String method, String parameters) throws IOException, InterruptedException {
        int number = ++count;
        socket.sendText(
                        String.format(
                                "{\"id\":%d,\"method\":\"%s\",\"params\":{%s}}",
                                number, method, parameters),
                        true)
                .join();
        while (true) {
            String told = answers.poll(MOST_SECONDS, TimeUnit.SECONDS);
            if (told == null) {
                throw new IOException("the browser does not answer " + method);
            }
            Matcher answer = NUMBER.matcher(told);
            if (!answer.find()) {
                events.accept(told);
            } else if (Integer.parseInt(answer.group(1)) == number) {
                return told;
            }
        }
    }

    /** Breaks the connection. */
    void close() {
        socket.abort();
    }

    /** A text as a string of JSON. */
    static String quoted(String text) {
        return '"' + text.replace("\\", "\\\\").replace("\"", "\\\"") + '"';
    }
}
