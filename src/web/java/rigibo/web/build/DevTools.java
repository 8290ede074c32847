package rigibo.web.build;

import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.net.http.WebSocket;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** A page in a running browser, driven by Chromium's DevTools protocol. */
final class DevTools implements AutoCloseable {

    private static final Pattern SOCKET = Pattern.compile("\"webSocketDebuggerUrl\": *\"([^\"]+)");
    private static final Pattern NUMBER = Pattern.compile("^\\{\"id\":(\\d+)");
    private static final Pattern VALUE =
            Pattern.compile("\"value\":(\"((?:[^\"\\\\]|\\\\.)*)\"|[^,}]+)");
    private static final Pattern DATA = Pattern.compile("\"data\":\"([^\"]*)\"");
    private static final Pattern URL = Pattern.compile("\"request\":\\{\"url\":\"([^\"]*)\"");

    /** A page that says nothing for so long is broken. */
    private static final int MOST_SECONDS = 60;

    private final BlockingQueue<String> answers = new LinkedBlockingQueue<>();
    private final List<String> requests = new ArrayList<>();
    private final List<String> complaints = new ArrayList<>();
    private final WebSocket socket;
    private int count;

    /** Takes the first page of a browser that listens at a port. */
    DevTools(int port) throws IOException, InterruptedException {
        HttpClient client = HttpClient.newHttpClient();
        HttpRequest list =
                HttpRequest.newBuilder(URI.create("http://localhost:" + port + "/json/list"))
                        .timeout(Duration.ofSeconds(MOST_SECONDS))
                        .build();
        String pages = client.send(list, HttpResponse.BodyHandlers.ofString()).body();
        Matcher found = SOCKET.matcher(pages);
        if (!found.find()) {
            throw new IOException("the browser has no page: " + pages);
        }
        socket =
                client.newWebSocketBuilder()
                        .buildAsync(URI.create(found.group(1)), new Listener())
                        .join();
        for (String domain : List.of("Page", "Runtime", "Network", "Log")) {
            send(domain + ".enable", "");
        }
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
                note(told);
            } else if (Integer.parseInt(answer.group(1)) == number) {
                return told;
            }
        }
    }

    private void note(String event) {
        if (event.contains("\"Network.requestWillBeSent\"")) {
            Matcher url = URL.matcher(event);
            requests.add(url.find() ? url.group(1) : event);
        }
        boolean isComplaint =
                event.contains("\"Runtime.exceptionThrown\"")
                        || event.contains("\"Runtime.consoleAPICalled\"")
                        || event.contains("\"Log.entryAdded\"") && event.contains("\"error\"");
        if (isComplaint) {
            complaints.add(event);
        }
    }

    /** What an expression of JavaScript comes to, as text. */
    String value(String script) throws IOException, InterruptedException {
        String answer =
                send(
                        "Runtime.evaluate",
                        "\"awaitPromise\":true,\"returnByValue\":true,\"expression\":\""
                                + script.replace("\\", "\\\\").replace("\"", "\\\"")
                                + "\"");
        Matcher value = VALUE.matcher(answer);
        if (!value.find()) {
            return answer.contains("\"undefined\"") ? "undefined" : answer;
        }
        return value.group(2) == null ? value.group(1) : value.group(2);
    }

    /** A finger comes down at a point of the page, px. */
    void down(double x, double y) throws IOException, InterruptedException {
        touch("touchStart", point(x, y));
    }

    /** The finger slides to a point of the page, px, and is lifted there. */
    void lift(double x, double y) throws IOException, InterruptedException {
        touch("touchMove", point(x, y));
        touch("touchEnd", "");
    }

    private static String point(double x, double y) {
        return String.format(Locale.ROOT, "{\"x\":%.2f,\"y\":%.2f}", x, y);
    }

    private void touch(String kind, String point) throws IOException, InterruptedException {
        send(
                "Input.dispatchTouchEvent",
                "\"type\":\"" + kind + "\",\"touchPoints\":[" + point + "]");
    }

    /** The page as a picture, a PNG. */
    byte[] picture() throws IOException, InterruptedException {
        Matcher data = DATA.matcher(send("Page.captureScreenshot", "\"format\":\"png\""));
        if (!data.find()) {
            throw new IOException("the browser makes no picture");
        }
        return Base64.getDecoder().decode(data.group(1));
    }

    /** Every address that was asked for. */
    List<String> requests() {
        return requests;
    }

    /** What the page wrote to the console, and its errors. */
    List<String> complaints() {
        return complaints;
    }

    @Override
    public void close() {
        socket.abort();
    }
}
