namespace Engraver.Core.Dxf.Tags;

/// <summary>A DXF as a stream of (group code, value) pairs over its bytes. Nothing is copied: a value is a span of the file.</summary>
/// <param name="arriving">The file; no byte is read before it has arrived.</param>
internal abstract class DxfTagSource(IProgressiveBytes arriving)
{
    private const int CommentCode = 999;

    /// <summary>Kept as an array, because taking the span of a memory costs time at every pair.</summary>
    private readonly byte[] _file = arriving.Bytes;
    private int _arrived;

    /// <summary>Group code of the pair read last.</summary>
    public int Code { get; protected set; }

    /// <summary>Position of the pair's code: line of an ASCII file (1 is the first), byte offset in a binary one.</summary>
    public int Line { get; protected set; }

    /// <summary>Position of the pair's value: the line after the code, or the pair's own offset.</summary>
    public int ValueLine => IsBinary ? Line : Line + 1;

    /// <summary>True after <see cref="Read"/> reached the end of the file.</summary>
    public bool AtEnd { get; private set; }

    /// <summary>True when the file ended inside a pair: the last value may be incomplete.</summary>
    public bool CutInsidePair { get; protected set; }

    /// <summary>Line of the last text that could not be read as a pair; -1 when there was none.</summary>
    public int DamageLine { get; private set; } = -1;

    /// <summary>The text at <see cref="DamageLine"/>, shortened.</summary>
    public string DamageText { get; private set; } = "";

    /// <summary>Number of such places.</summary>
    public int DamageCount { get; private set; }

    public abstract bool IsBinary { get; }

    /// <summary>True when the texts are known to be UTF-8, whatever the header states.</summary>
    public bool IsUtf8 { get; init; }

    /// <summary>The value's bytes, without the line end; for a number of a binary file its raw bytes.</summary>
    public abstract ReadOnlySpan<byte> Value { get; }

    /// <summary>Part of the file that has been read, 0 to 1.</summary>
    public double Part => (double)Position / Math.Max(1, _file.Length);

    /// <summary>The bytes that have been waited for so far, from the first byte on.</summary>
    protected ReadOnlySpan<byte> Bytes => new(_file, 0, _arrived);

    /// <summary><see cref="Bytes"/> are the whole file.</summary>
    protected bool IsWhole => _arrived == _file.Length;

    protected int Position { get; set; }

    /// <summary>Reads the next pair, comments left out; false at the end of the file.</summary>
    public bool Read()
    {
        while (ReadPair())
        {
            if (Code != CommentCode) return true;
        }

        AtEnd = true;
        return false;
    }

    /// <summary>The value as a finite number, whole numbers included; false when it is not a number.</summary>
    public abstract bool TryNumber(out double number);

    /// <summary>Offset of the last place in the file where the word is a whole value (between line ends or NULs); -1 when there is none.</summary>
    public int LastWord(ReadOnlySpan<byte> word)
    {
        WaitForAll();
        var bytes = Bytes;
        for (var at = bytes.LastIndexOf(word); at >= 0; at = bytes[..at].LastIndexOf(word))
        {
            var end = at + word.Length;
            if (at > 0 && bytes[at - 1] < ' ' && (end == bytes.Length || bytes[end] < ' ')) return at;
        }

        return -1;
    }

    /// <summary>The present position, for <see cref="Return"/>.</summary>
    public (int Position, int Line) Bookmark() => (Position, NextLine);

    public void Return((int Position, int Line) bookmark)
    {
        Position = bookmark.Position;
        NextLine = bookmark.Line;
        CutInsidePair = false;
        AtEnd = false;
    }

    /// <summary>Number of zero bytes in the part of a text that has been read, and the line of the first; 0 where zeros are part of the format, or only fill
    /// the end.</summary>
    public virtual (int Count, int Line) ZeroBytes() => default;

    protected int NextLine { get; set; }

    protected abstract bool ReadPair();

    /// <summary>Waits until this number of bytes, or the whole file, has arrived.</summary>
    /// <exception cref="IOException">The file cannot be read up to this number.</exception>
    protected void WaitFor(int count) => _arrived = arriving.WaitFor(Math.Min(count, _file.Length));

    /// <summary>Waits for the whole file.</summary>
    /// <exception cref="IOException">It cannot be read.</exception>
    protected void WaitForAll() => WaitFor(_file.Length);

    protected void Damage(int line, string text)
    {
        DamageLine = line;
        DamageText = text;
        DamageCount++;
    }
}
