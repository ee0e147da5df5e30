using Engraver.Cli.Terminals;

namespace Engraver.Cli.Tests.Terminals;

public class LineEditorTests
{
    [Fact]
    public void Characters_go_in_where_the_cursor_is()
    {
        var editor = Typed([], "VP 10");
        Press(editor, ConsoleKey.LeftArrow, ConsoleKey.LeftArrow);
        Type(editor, "-");
        Press(editor, ConsoleKey.End, ConsoleKey.Backspace, ConsoleKey.Home, ConsoleKey.Delete);

        Assert.Equal(("P -1", 0), (editor.Text, editor.Cursor));
    }

    [Fact]
    public void Up_and_down_walk_through_the_history_and_come_back_to_the_draft()
    {
        var editor = Typed(["MG 1", "MG 2"], "dra");

        Press(editor, ConsoleKey.UpArrow);
        Assert.Equal("MG 2", editor.Text);
        Press(editor, ConsoleKey.UpArrow, ConsoleKey.UpArrow);
        Assert.Equal("MG 1", editor.Text);
        Press(editor, ConsoleKey.DownArrow, ConsoleKey.DownArrow, ConsoleKey.DownArrow);
        Assert.Equal("dra", editor.Text);
    }

    [Fact]
    public void Enter_ends_the_line_and_other_keys_do_not()
    {
        var editor = Typed([], "ST");
        Press(editor, ConsoleKey.Backspace, ConsoleKey.Backspace, ConsoleKey.Backspace, ConsoleKey.Delete, ConsoleKey.LeftArrow, ConsoleKey.RightArrow);

        Assert.Equal("", editor.Text);
        Assert.True(editor.Press(new ConsoleKeyInfo('\r', ConsoleKey.Enter, false, false, false)));
    }

    [Fact]
    public void Escape_empties_the_line_and_control_characters_are_no_text()
    {
        var editor = Typed([], "abc\u0001");
        Assert.Equal("abc", editor.Text);
        Press(editor, ConsoleKey.Escape);

        Assert.Equal(("", 0), (editor.Text, editor.Cursor));
    }

    private static LineEditor Typed(IReadOnlyList<string> history, string text)
    {
        var editor = new LineEditor(history);
        Type(editor, text);
        return editor;
    }

    private static void Type(LineEditor editor, string text)
    {
        foreach (var character in text) Assert.False(editor.Press(new ConsoleKeyInfo(character, ConsoleKey.None, false, false, false)));
    }

    private static void Press(LineEditor editor, params ConsoleKey[] keys)
    {
        foreach (var key in keys) Assert.False(editor.Press(new ConsoleKeyInfo('\0', key, false, false, false)));
    }
}
