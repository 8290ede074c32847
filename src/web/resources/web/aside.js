// A thread beside the page: runs the program with the words that it is given, once.
importScripts('runtime.js', 'game-functions.js');

onmessage = given => {
    TeaVM.wasmGC.load('game.wasm')
        .then(program => program.exports.main(given.data))
        // The page hears of errors, not of promises that were not kept.
        .catch(problem => setTimeout(() => { throw problem; }));
};
