package rigibo.web.build;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** A page in a running browser, driven by WebDriver BiDi, the protocol that Firefox speaks. */
final class Bidi implements Page {

    private static final Pattern CONTEXT = Pattern.compile("\"context\":\"([^\"]+)\"");
    private static final Pattern URL = Pattern.compile("\"url\":\"([^\"]*)\"");

    private final List<String> requests = new ArrayList<>();
    private final List<String> complaints = new ArrayList<>();
    private final Wire wire;
    private final String context;

    /** Opens an empty page in a browser that listens at a port. */
    Bidi(int port) throws IOException, InterruptedException {
        wire = new Wire("ws://localhost:" + port + "/session", this::note);
        wire.send("session.new", "\"capabilities\":{}");
        wire.send(
                "session.subscribe",
                "\"events\":[\"log.entryAdded\",\"network.beforeRequestSent\"]");
        String made = wire.send("browsingContext.create", "\"type\":\"tab\"");
        Matcher found = CONTEXT.matcher(made);
        if (!found.find()) {
            throw new IOException("the browser opens no page: " + made);
        }
        context = "\"context\":\"" + found.group(1) + "\"";
    }

    private void note(String event) {
        if (event.contains("\"network.beforeRequestSent\"")) {
            Matcher url = URL.matcher(event);
            requests.add(url.find() ? url.group(1) : event);
        } else if (event.contains("\"log.entryAdded\"")) {
            complaints.add(event);
        }
    }

    @Override
    public void size(int width, int height) throws IOException, InterruptedException {
        wire.send(
                "browsingContext.setViewport",
                String.format(
                        "%s,\"viewport\":{\"width\":%d,\"height\":%d},\"devicePixelRatio\":1",
                        context, width, height));
    }

    @Override
    public void begin(String script) throws IOException, InterruptedException {
        wire.send(
                "script.addPreloadScript",
                "\"functionDeclaration\":" + Wire.quoted("() => { " + script + " }"));
    }

    @Override
    public void open(String address) throws IOException, InterruptedException {
        wire.send(
                "browsingContext.navigate",
                context + ",\"wait\":\"complete\",\"url\":" + Wire.quoted(address));
    }

    @Override
    public String value(String script) throws IOException, InterruptedException {
        return wire.value(
                "script.evaluate",
                "\"awaitPromise\":true,\"target\":{"
                        + context
                        + "},\"expression\":"
                        + Wire.quoted(script));
    }

    @Override
    public void click(Spot at) throws IOException, InterruptedException {
        wire.send(
                "input.performActions",
                String.format(
                        Locale.ROOT,
                        "%s,\"actions\":[{\"type\":\"pointer\",\"id\":\"mouse\",\"actions\":["
                                + "{\"type\":\"pointerMove\",\"x\":%.0f,\"y\":%.0f},"
                                + "{\"type\":\"pointerDown\",\"button\":0},"
                                + "{\"type\":\"pointerUp\",\"button\":0}]}]",
                        context,
                        at.x(),
                        at.y()));
    }

    @Override
    public byte[] picture() throws IOException, InterruptedException {
        return wire.picture("browsingContext.captureScreenshot", context);
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
        wire.send("session.end", "");
        wire.close();
    }
}
