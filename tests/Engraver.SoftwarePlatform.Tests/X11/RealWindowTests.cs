using System.Globalization;

namespace Engraver.SoftwarePlatform.Tests.X11;

/// <summary>A real window under a real X server and window manager, controlled by another program.</summary>
public sealed class RealWindowTests : IDisposable
{
    private readonly XServer _server = new();
    private readonly ShownWindow _window;

    public RealWindowTests() => _window = new ShownWindow(_server);

    private LineProcess Program => _window.Program;

    public void Dispose()
    {
        _window.Dispose();
        _server.Dispose();
    }

    [XServerFact]
    public void A_click_presses_and_typed_text_arrives()
    {
        _server.Click(_window.Counter.X, _window.Counter.Y);
        Program.WaitFor("pressed 1");

        TypeInto("xdotool", "Feed 12.5 mm/s (X_1) + 2");
        Program.WaitFor("text Feed 12.5 mm/s (X_1) + 2");
    }

    [XServerFact]
    public void The_wheel_scrolls()
    {
        _server.Click(_window.Rows.X, _window.Rows.Y, button: 5);

        Program.WaitFor("scrolled");
    }

    [XServerFact]
    public void The_window_follows_a_resize()
    {
        _server.Run("xdotool", "windowsize", _window.Id, "901", "602");

        Program.WaitFor("size 901 602");
    }

    [XServerFact]
    public void The_clipboard_goes_out_and_comes_in()
    {
        Program.Send("copy größe ✓");
        Program.WaitFor("copied");
        Assert.Equal("größe ✓", _server.Run("xclip", "-selection", "clipboard", "-o", "-t", "UTF8_STRING"));
        Assert.Contains("text/plain;charset=utf-8", _server.Run("xclip", "-selection", "clipboard", "-o", "-t", "TARGETS"), StringComparison.Ordinal);

        using var other = new OtherProgram(_server);
        other.GiveClipboardTo(() => _server.OfferClipboard("von außen ✓"));
        Assert.Equal("von außen ✓", _server.Run("xclip", "-selection", "clipboard", "-o", "-t", "UTF8_STRING"));
        Program.Send("paste");
        Assert.Equal("clipboard von außen ✓", Program.WaitFor("clipboard"));
    }

    [XServerFact]
    public void A_clipboard_larger_than_one_request_goes_in_pieces()
    {
        Program.Send("copylong 700000");
        Program.WaitFor("copied");
        Assert.Equal(new string('ä', 700_000), _server.Run("xclip", "-selection", "clipboard", "-o", "-t", "UTF8_STRING"));

        using var other = new OtherProgram(_server);
        other.GiveClipboardTo(() => _server.OfferClipboard(new string('ß', 1_500_000)));
        Program.Send("pastelong");
        Assert.Equal("clipboard length 1500000", Program.WaitFor("clipboard"));
    }

    [XServerFact]
    public void Another_layout_brings_its_letters_and_dead_keys()
    {
        _server.Run("setxkbmap", "de");
        _server.Click(_window.Entry.X, _window.Entry.Y);
        Program.WaitFor("entry focused");
        _server.Run("xdotool", "key", "odiaeresis", "ssharp", "y", "dead_acute", "e", "dead_grave", "a");

        Program.WaitFor("text ößyéà");
    }

    [XServerFact]
    public void Keys_mean_what_the_layout_says()
    {
        _server.Run("setxkbmap", "de");
        _server.Run("xdotool", "key", "--clearmodifiers", "z");
        Program.WaitFor("filter Z down");
        _server.Press("ctrl+space");
        Program.WaitFor("filter Space down Control");
        Program.WaitFor("key Space");
    }

    /// <summary>The order proves it: the filter has replied before the user interface is released.</summary>
    [XServerFact]
    public void The_key_filter_is_called_while_the_user_interface_is_blocked()
    {
        Program.Send("block");
        Program.WaitFor("blocked");
        _server.Press("Pause");
        Program.WaitFor("filter Pause down");
        Assert.DoesNotContain("released", Program.Lines);

        Program.Send("release");
        Program.WaitFor("released");
        _server.Press("F5");
        Program.WaitFor("key F5");
        Assert.DoesNotContain("key Pause", Program.Lines);
    }

    [XServerFact]
    public void A_region_answers_while_the_user_interface_is_blocked()
    {
        Program.Send("region");
        Program.WaitFor("region added");
        Program.Send("block");
        Program.WaitFor("blocked");
        _server.Click(_window.Counter.X, _window.Counter.Y);
        Program.WaitFor("region pressed");
        Assert.DoesNotContain("released", Program.Lines);

        Program.Send("release");
        Program.WaitFor("released");
        _server.Press("F5");
        Program.WaitFor("key F5");
        Assert.DoesNotContain("pressed 1", Program.Lines);
    }

    [XServerFact]
    public void A_modal_dialog_stops_its_owner_and_gives_its_answer()
    {
        Program.Send("dialog");
        Program.WaitFor("dialog active");
        _server.Click(_window.Counter.X - 30, _window.Counter.Y);
        _server.Press("Return");

        Program.WaitFor("dialog answered yes");
        Assert.DoesNotContain("pressed 1", Program.Lines);
    }

    [XServerFact]
    public void The_window_manager_s_states_come_and_go()
    {
        Program.Send("state Maximized");
        Program.WaitFor("size 1280 ");
        Program.Send("state FullScreen");
        Program.WaitFor("size 1280 900");
        Program.Send("state Normal");
        Program.WaitFor("size 800 520");
    }

    [XServerFact]
    public void Files_dragged_from_another_program_arrive()
    {
        using var other = new OtherProgram(_server);
        var taken = other.Drop(nint.Parse(_window.Id, CultureInfo.InvariantCulture), _window.Rows.X, _window.Rows.Y, "file:///tmp/gr%C3%B6%C3%9Fe.dxf\r\nfile:///tmp/b.dxf\r\n");

        Assert.Equal("dropped /tmp/größe.dxf|/tmp/b.dxf", Program.WaitFor("dropped"));
        Assert.True(taken);
    }

    [XServerFact]
    public void Closing_is_asked_of_the_window()
    {
        using var other = new OtherProgram(_server);
        other.AskToClose(nint.Parse(_window.Id, CultureInfo.InvariantCulture));
        Program.WaitFor("closing");

        Assert.Equal(0, Program.WaitForExit());
    }

    [XServerFact]
    public void A_window_destroyed_by_another_program_ends_as_if_closed()
    {
        _server.Run("xdotool", "windowclose", _window.Id);

        Assert.Equal(0, Program.WaitForExit());
    }

    [XServerFact]
    public void Title_and_process_are_told_to_the_window_manager()
    {
        var told = _server.Run("xprop", "-id", _window.Id, "_NET_WM_NAME", "WM_CLASS", "WM_PROTOCOLS", "XdndAware");

        Assert.Contains("\"Software platform: größe ✓\"", told, StringComparison.Ordinal);
        Assert.Contains("WM_CLASS(STRING) = \"demo\", \"demo\"", told, StringComparison.Ordinal);
        Assert.Contains("WM_DELETE_WINDOW, _NET_WM_PING", told, StringComparison.Ordinal);
        Assert.Contains("XdndAware(ATOM) = BITMAP", told, StringComparison.Ordinal); // the atom numbered 5
    }

    [XServerFact]
    public void A_server_that_goes_away_ends_the_program_in_order()
    {
        _server.Kill();

        Program.WaitFor("lost The X display has gone");
        Assert.Equal(1, Program.WaitForExit());
    }

    private void TypeInto(string program, string text)
    {
        _server.Click(_window.Entry.X, _window.Entry.Y);
        Program.WaitFor("entry focused");
        _server.Run(program, "type", "--delay", "1", text);
    }
}
