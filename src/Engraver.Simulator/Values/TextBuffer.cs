namespace Engraver.Simulator.Values;

/// <summary>Reusable text that grows in one array: replies and messages, one Latin-1 character for each byte.</summary>
internal sealed class TextBuffer
{
    private char[] _characters = new char[128];

    public int Length { get; private set; }

    public ReadOnlySpan<char> Text => _characters.AsSpan(0, Length);

    public void Clear() => Length = 0;

    public TextBuffer Append(char c)
    {
        Room(1)[0] = c;
        Length++;
        return this;
    }

    public TextBuffer Append(ReadOnlySpan<char> text)
    {
        text.CopyTo(Room(text.Length));
        Length += text.Length;
        return this;
    }

    public TextBuffer Append(string text) => Append(text.AsSpan());

    private Span<char> Room(int length)
    {
        if (Length + length > _characters.Length) Array.Resize(ref _characters, Math.Max(_characters.Length * 2, Length + length));
        return _characters.AsSpan(Length);
    }
}
