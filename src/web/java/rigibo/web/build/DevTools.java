package rigibo.web.build;

import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** A page in a running browser, driven by Chromium's DevTools protocol. */
final class DevTools implements Page {

    private static final Pattern SOCKET = Pattern.compile("\"webSocketDebuggerUrl\": *\"([^\"]+)");
    private static final Pattern URL = Pattern.compile("\"request\":\\{\"url\":\"([^\"]*)\"");

    /** Longest silence of a page, s; after it the page counts as broken. */
    private static final int MOST_SECONDS = 60;

    /**
     * Time between the events of a touch, s: a late browser must not take a short touch for a long
     * one.
     */
    private static final double BETWEEN_TOUCHES = 0.02;

    private final List<String> requests = new ArrayList<>();
    private final List<String> complaints = new ArrayList<>();
    private final Wire wire;

    /** Time of the last touch event, s since 1970. */
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
        wire = new Wire(found.group(1), this::note);
        for (String domain : List.of("Page", "Runtime", "Network", "Log")) {
            send(domain + ".enable", "");
        }
    }

    /** Calls a method with parameters in JSON, without their braces; returns the answer. */
    String send(String method, String parameters) throws IOException, InterruptedException {
        return wire.send(method, parameters);
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

    @Override
    public void size(int width, int height) throws IOException, InterruptedException {
        size(width, height, 1, false);
    }

    /** Sets the size of the page, and the number of screen pixels for each of its own. */
    void size(int width, int height, double ratio) throws IOException, InterruptedException {
        size(width, height, ratio, false);
    }

    /** Sets the size of the page to that of a phone with a touch screen, px. */
    void phone(int width, int height) throws IOException, InterruptedException {
        size(width, height, 1, true);
        send("Emulation.setTouchEmulationEnabled", "\"enabled\":true");
    }

    private void size(int width, int height, double ratio, boolean isMobile)
            throws IOException, InterruptedException {
        send(
                "Emulation.setDeviceMetricsOverride",
                String.format(
                        Locale.ROOT,
                        "\"width\":%d,\"height\":%d,\"deviceScaleFactor\":%.2f,\"mobile\":%b",
                        width,
                        height,
                        ratio,
                        isMobile));
    }

    @Override
    public void begin(String script) throws IOException, InterruptedException {
        send("Page.addScriptToEvaluateOnNewDocument", "\"source\":" + Wire.quoted(script));
    }

    @Override
    public void open(String address) throws IOException, InterruptedException {
        send("Page.navigate", "\"url\":" + Wire.quoted(address));
    }

    @Override
    public String value(String script) throws IOException, InterruptedException {
        return wire.value(
                "Runtime.evaluate",
                "\"awaitPromise\":true,\"returnByValue\":true,\"expression\":"
                        + Wire.quoted(script));
    }

    /** Puts fingers down at points of the page; only the last of them is new. */
    void down(Spot... points) throws IOException, InterruptedException {
        touch("touchStart", points);
    }

    /** Moves fingers to points of the page. */
    void slide(Spot... points) throws IOException, InterruptedException {
        touch("touchMove", points);
    }

    /** Moves a finger to a point of the page and lifts it there. */
    void lift(Spot point) throws IOException, InterruptedException {
        slide(point);
        lift();
    }

    /** Lifts all fingers. */
    void lift() throws IOException, InterruptedException {
        touch("touchEnd");
    }

    private void touch(String kind, Spot... points) throws IOException, InterruptedException {
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

    @Override
    public void click(Spot at) throws IOException, InterruptedException {
        for (String kind : List.of("mouseMoved", "mousePressed", "mouseReleased")) {
            send(
                    "Input.dispatchMouseEvent",
                    String.format(
                            Locale.ROOT,
                            "\"type\":\"%s\",\"x\":%.2f,\"y\":%.2f,\"button\":\"left\","
                                    + "\"clickCount\":1",
                            kind,
                            at.x(),
                            at.y()));
        }
    }

    @Override
    public byte[] picture() throws IOException, InterruptedException {
        return wire.picture("Page.captureScreenshot", "\"format\":\"png\"");
    }

    @Override
    public List<String> requests() {
        return requests;
    }

    @Override
    public List<String> complaints() {
        return complaints;
    }

    @Override
    public void close() throws IOException, InterruptedException {
        send("Page.close", "");
        wire.close();
    }
}
