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
final class DevTools {

    private static final Pattern SOCKET = Pattern.compile("\"webSocketDebuggerUrl\": *\"([^\"]+)");
    private static final Pattern NUMBER = Pattern.compile("^\\{\"id\":(\\d+)");
    private static final Pattern VALUE =
            Pattern.compile("\"value\":(\"((?:[^\"\\\\]|\\\\.)*)\"|[^,}]+)");
    private static final Pattern DATA = Pattern.compile("\"data\":\"([^\"]*)\"");
    private static final Pattern URL = Pattern.compile("\"request\":\\{\"url\":\"([^\"]*)\"");

    /** A page that says nothing for so long is broken. */
    private static final int MOST_SECONDS = 60;

    /**
     * Time from a touch to what becomes of it next, s: a browser that is late must not take a short
     * touch for a long one.
     */
    private static final double BETWEEN_TOUCHES = 0.02;

    private final BlockingQueue<String> answers = new LinkedBlockingQueue<>();
    private final List<String> requests = new ArrayList<>();
    private final List<String> complaints = new ArrayList<>();
    private final WebSocket socket;
    private int count;

    /** When a finger last did something, s since 1970. */
    private double touched = System.currentTimeMillis() / 1e3;

    /** Opens an empty page in a browser that listens at a port. */
    DevTools(int port) throws IOException, InterruptedException {
        HttpClient client = HttpClient.newHttpClient();
        HttpRequest opening =
                HttpRequest.newBuilder(URI.create("http://localhost:" + port + "/json/new"))
                        .PUT(HttpRequest.BodyPublishers.noBody())
                        .timeout(Duration.ofSeconds(MOST_SECONDS))
                        .build();
        String opened = client.send(opening, HttpResponse.BodyHandlers.ofString()).body();
        Matcher found = SOCKET.matcher(opened);
        if (!found.find()) {
            throw new IOException("the browser opens no page: " + opened);
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

    /** Fingers are down at points of the page, the last of them only now. */
    void down(Phone.Spot... points) throws IOException, InterruptedException {
        touch("touchStart", points);
    }

    /** Fingers slide to points of the page. */
    void slide(Phone.Spot... points) throws IOException, InterruptedException {
        touch("touchMove", points);
    }

    /** A finger slides to a point of the page, and is lifted there. */
    void lift(Phone.Spot point) throws IOException, InterruptedException {
        slide(point);
        lift();
    }

    /** All fingers are lifted. */
    void lift() throws IOException, InterruptedException {
        touch("touchEnd");
    }

    private void touch(String kind, Phone.Spot... points) throws IOException, InterruptedException {
        touched += BETWEEN_TOUCHES;
        List<String> written = new ArrayList<>();
        for (int i = 0; i < points.length; i++) {
            written.add(
                    String.format(
                            Locale.ROOT,
                            "{\"x\":%.2f,\"y\":%.2f,\"id\":%d}",
                            points[i].x(),
                            points[i].y(),
                            i));
        }
        send(
                "Input.dispatchTouchEvent",
                String.format(
                        Locale.ROOT,
                        "\"type\":\"%s\",\"timestamp\":%.3f,\"touchPoints\":[%s]",
                        kind,
                        touched,
                        String.join(",", written)));
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

    /** Closes the page. */
    void close() throws IOException, InterruptedException {
        send("Page.close", "");
        socket.abort();
    }
}
