package rigibo.web.build;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Future;

/** Serves a folder to browsers on this machine, and to no other machine. */
final class LocalServer implements AutoCloseable {

    private static final Map<String, String> KINDS =
            Map.of(
                    "html", "text/html; charset=utf-8",
                    "js", "text/javascript; charset=utf-8",
                    "css", "text/css; charset=utf-8",
                    "wasm", "application/wasm",
                    "txt", "text/plain; charset=utf-8",
                    "ttf", "font/ttf",
                    "svg", "image/svg+xml",
                    "webmanifest", "application/manifest+json");

    private static final int NOT_FOUND = 404;
    private static final int FOUND = 200;
    private static final int NO_CONTENT = 204;

    /** Address at which a page posts its output. */
    private static final String SAID = "/said";

    private final Path folder;
    private final HttpServer server;
    private final CompletableFuture<String> said = new CompletableFuture<>();

    /** Serves at a port, or at any free one if it is 0. */
    LocalServer(Path folder, int port) throws IOException {
        this.folder = folder.toAbsolutePath().normalize();
        server =
                HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), port), 0);
        server.createContext("/", this::answer);
        server.createContext(SAID, this::listen);
        server.start();
    }

    /** The address of a page of the folder. */
    String address(String page) {
        return "http://localhost:" + server.getAddress().getPort() + "/" + page;
    }

    /** The first post of a page. */
    Future<String> said() {
        return said;
    }

    private void listen(HttpExchange asked) throws IOException {
        try (asked) {
            byte[] bytes = asked.getRequestBody().readAllBytes();
            asked.sendResponseHeaders(NO_CONTENT, -1);
            said.complete(new String(bytes, StandardCharsets.UTF_8));
        }
    }

    private void answer(HttpExchange asked) throws IOException {
        String name = asked.getRequestURI().getPath().substring(1);
        Path file = folder.resolve(name.isEmpty() ? "index.html" : name).normalize();
        try (asked) {
            if (!file.startsWith(folder) || !Files.isRegularFile(file)) {
                asked.sendResponseHeaders(NOT_FOUND, -1);
                return;
            }
            String ending = name.substring(name.lastIndexOf('.') + 1);
            asked.getResponseHeaders()
                    .set("Content-Type", KINDS.getOrDefault(ending, KINDS.get("html")));
            byte[] bytes = Files.readAllBytes(file);
            asked.sendResponseHeaders(FOUND, bytes.length);
            asked.getResponseBody().write(bytes);
        }
    }

    @Override
    public void close() {
        server.stop(0);
    }
}
