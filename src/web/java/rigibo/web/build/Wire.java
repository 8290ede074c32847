package rigibo.web.build;

import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.util.Base64;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Calls methods of a browser, and passes its events on. */
final class Wire {

    private static final Pattern NUMBER =
            Pattern.compile("^\\{(?:\"type\":\"(?:success|error)\",)?\"id\":(\\d+)");

    private static final Pattern VALUE =
            Pattern.compile("\"value\":(\"((?:[^\"\\\\]|\\\\.)*)\"|[^,}]+)");
    private static final Pattern DATA = Pattern.compile("\"data\":\"([^\"]*)\"");

    /** Longest silence of a browser, s; after it the browser counts as broken. */
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

    /** Calls a method that evaluates an expression; returns its value as text. */
    String value(String method, String parameters) throws IOException, InterruptedException {
        String answer = send(method, parameters);
        Matcher value = VALUE.matcher(answer);
        if (!value.find()) {
            return answer.contains("\"undefined\"") ? "undefined" : answer;
        }
        return value.group(2) == null ? value.group(1) : value.group(2);
    }

    /** Calls a method that makes a picture; returns it, a PNG. */
    byte[] picture(String method, String parameters) throws IOException, InterruptedException {
        Matcher data = DATA.matcher(send(method, parameters));
        if (!data.find()) {
            throw new IOException("the browser makes no picture");
        }
        return Base64.getDecoder().decode(data.group(1));
    }

    /** Closes the connection. */
    void close() {
        socket.abort();
    }

    /** A text as a string of JSON. */
    static String quoted(String text) {
        return '"' + text.replace("\\", "\\\\").replace("\"", "\\\"") + '"';
    }
}
