using System.Text;

namespace Engraver.Cli.Terminals;

/// <summary>The line being typed: editing keys and history. Independent of the screen.</summary>
/// <param name="history">Oldest first.</param>
internal sealed class LineEditor(IReadOnlyList<string> history)
{
    private readonly StringBuilder _text = new();
    private int _recalled = history.Count;
    private string _draft = "";

    public string Text => _text.ToString();

    /// <summary>Insertion position.</summary>
    public int Cursor { get; private set; }

    /// <summary>Processes a key.</summary>
    /// <returns>True when the line is finished.</returns>
    public bool Press(ConsoleKeyInfo key)
    {
        switch (key.Key)
        {
            case ConsoleKey.Enter: return true;
            case ConsoleKey.Backspace when Cursor > 0: _text.Remove(--Cursor, 1); break;
            case ConsoleKey.Delete when Cursor < _text.Length: _text.Remove(Cursor, 1); break;
            case ConsoleKey.LeftArrow: Cursor = Math.Max(0, Cursor - 1); break;
            case ConsoleKey.RightArrow: Cursor = Math.Min(_text.Length, Cursor + 1); break;
            case ConsoleKey.Home: Cursor = 0; break;
            case ConsoleKey.End: Cursor = _text.Length; break;
            case ConsoleKey.Escape: Replace(""); break;
            case ConsoleKey.UpArrow: Recall(_recalled - 1); break;
            case ConsoleKey.DownArrow: Recall(_recalled + 1); break;
            default: Insert(key.KeyChar); break;
        }

        return false;
    }

    private void Insert(char character)
    {
        if (!char.IsControl(character)) _text.Insert(Cursor++, character);
    }

    /// <summary>Moves through the history; after its last line comes the line that was being typed.</summary>
    private void Recall(int place)
    {
        if (place < 0 || place > history.Count) return;
        if (_recalled == history.Count) _draft = Text;
        _recalled = place;
        Replace(place == history.Count ? _draft : history[place]);
    }

    private void Replace(string text)
    {
        _text.Clear().Append(text);
        Cursor = text.Length;
    }
}
