using Engraver.Core;
using Engraver.Core.Posts;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Playback;

namespace Engraver.App.Desk;

/// <summary>The lines of the posted program of a motion. A long program is written in the background; until then the list is empty.</summary>
internal sealed record PostedLines(PlannedMotion? Motion, Task<IReadOnlyList<string>> Written)
{
    /// <summary>A program of at most this many segments is written synchronously.</summary>
    private const int ShortProgram = 20_000;

    public static PostedLines None { get; } = new(null, Task.FromResult<IReadOnlyList<string>>([]));

    public IReadOnlyList<string> Lines => Written.IsCompletedSuccessfully ? Written.Result : [];

    public static PostedLines Of(DerivedDocument derived)
    {
        if (derived.Motion is not { } motion) return None;
        if (derived.IsPosted || motion.SegmentCount <= ShortProgram) return new PostedLines(motion, Task.FromResult<IReadOnlyList<string>>(SplitLines(derived.Program)));
        return new PostedLines(motion, Task.Run<IReadOnlyList<string>>(() => SplitLines(derived.Program)));
    }

    private static ChunkLines SplitLines(PostOutput? program) => new(program?.Chunks ?? []);
}

/// <summary>The lines of consecutive texts, cut on access: four bytes for each line in addition to the texts.</summary>
internal sealed class ChunkLines : IndexedList<string>
{
    private readonly IReadOnlyList<string> _chunks;
    private readonly int[] _firstLines;
    private readonly List<int> _starts = [];

    /// <param name="chunks">Each ends with a line end.</param>
    public ChunkLines(IReadOnlyList<string> chunks)
    {
        _chunks = chunks;
        _firstLines = new int[chunks.Count];
        for (var chunk = 0; chunk < chunks.Count; chunk++)
        {
            _firstLines[chunk] = _starts.Count;
            for (var at = 0; at < chunks[chunk].Length; at = EndOf(chunks[chunk], at) + 1) _starts.Add(at);
        }

        while (_starts.Count > 0 && this[_starts.Count - 1].Length == 0) _starts.RemoveAt(_starts.Count - 1);
    }

    public override int Count => _starts.Count;

    protected override string ItemAt(int index)
    {
        var chunk = Array.BinarySearch(_firstLines, index);
        if (chunk < 0) chunk = ~chunk - 1;
        var text = _chunks[chunk];
        return text[_starts[index]..EndOf(text, _starts[index])];
    }

    private static int EndOf(string text, int start) => text.IndexOf('\n', start) is >= 0 and var end ? end : text.Length;
}
