using Engraver.App.CommandWindow;

namespace Engraver.App.Tests.CommandWindow;

public sealed class InputHistoryTests
{
    [Fact]
    public void The_unfinished_line_comes_back_at_the_end()
    {
        var history = new InputHistory();
        history.Add("OPEN");
        history.Add("MOVE");

        Assert.Equal("MOVE", history.Back("ZO"));
        Assert.Equal("OPEN", history.Back("MOVE"));
        Assert.Equal("OPEN", history.Back("OPEN"));
        Assert.Equal("MOVE", history.Forward("OPEN"));
        Assert.Equal("ZO", history.Forward("MOVE"));
        Assert.Equal("ZO", history.Forward("ZO"));
    }

    [Fact]
    public void The_same_input_twice_and_enter_alone_are_kept_once_and_never()
    {
        var history = new InputHistory();
        history.Add("OPEN");
        history.Add("OPEN");
        history.Add("");

        Assert.Equal("OPEN", history.Back(""));
        Assert.Equal("OPEN", history.Back("OPEN"));
        Assert.Equal("", history.Forward("OPEN"));
    }
}
