// Keeps the game in the browser: after the first visit it opens without network.
const kept = 'rigibo-{version}';
const files = ['./', {files}];

self.addEventListener('install', event => {
    event.waitUntil(caches.open(kept).then(cache => cache.addAll(files)).then(() => self.skipWaiting()));
});

self.addEventListener('activate', event => {
    event.waitUntil(caches.keys()
        .then(names => Promise.all(names.filter(name => name !== kept).map(name => caches.delete(name))))
        .then(() => self.clients.claim()));
});

self.addEventListener('fetch', event => {
    event.respondWith(caches.match(event.request, {ignoreSearch: true}).then(found => found || fetch(event.request)));
});
