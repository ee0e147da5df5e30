namespace Engraver.SoftwarePlatform.Tests.X11;

/// <summary>A server without a window manager, as in a kiosk, and no server at all.</summary>
public sealed class BareServerTests
{
    [XServerFact]
    public void Without_a_window_manager_the_window_takes_the_keyboard()
    {
        using var server = new XServer(withWindowManager: false);
        using var window = new ShownWindow(server, scale: 1.5);
        server.Press("F5");

        window.Program.WaitFor("key F5");
    }

    [Fact]
    public void Without_a_display_one_sentence_says_so()
    {
        using var told = new LineProcess("dotnet", ":4711", typeof(BareServerTests).Assembly.Location);

        Assert.Equal(3, told.WaitForExit());
        Assert.Equal(["error: The X display \":4711\" cannot be opened: no server answers there, or it does not let this user in."], told.Lines);
    }
}
