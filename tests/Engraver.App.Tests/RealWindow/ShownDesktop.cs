using System.Diagnostics;
using System.Globalization;
using Avalonia;
using Engraver.App.Tests.Start;
using Engraver.SoftwarePlatform.Tests.X11;
using Engraver.TestKit;

namespace Engraver.App.Tests.RealWindow;

/// <summary>The desktop as a separate process on an X server, with a simulated user. Its state is read from its title, as the task bar shows it.</summary>
internal sealed class ShownDesktop : IDisposable
{
    private readonly TemporaryDesktopFolder? _ownFolder;
    private readonly string _folder;
    private readonly TemporaryDesktopFolder _screen = new();
    private static readonly TimeSpan s_untilAgain = TimeSpan.FromSeconds(3);
    private static readonly TimeSpan s_untilTypedAgain = TimeSpan.FromSeconds(10);
    private static readonly TimeSpan s_timeout = TimeSpan.FromSeconds(60); // only a failing test waits that long

    /// <summary>Two frames of the screen: polling more often takes processor time from the program under test.</summary>
    private static readonly TimeSpan s_interval = TimeSpan.FromMilliseconds(33);

    /// <summary>Number of equal pictures in a row, while the program is idle, after which the window counts as painted; the caret blinks every half
    /// second.</summary>
    private const int LooksAtRest = 14;

    /// <summary>Four seconds: the maximum wait for a busy program.</summary>
    private const int MaxLooks = 120;

    private readonly XServer _server;
    private readonly LineProcess _desktop;
    private readonly LineProcess _titles;

    /// <param name="folder">The operator's files, possibly those of an earlier desktop; null: a new folder.</param>
    public ShownDesktop(string? folder = null)
    {
        _ownFolder = folder is null ? new TemporaryDesktopFolder() : null;
        _folder = folder ?? _ownFolder!.Path;
        _server = new XServer(screenFolder: _screen.Path);
        var program = Path.Combine(AppContext.BaseDirectory, "engraver-desktop.dll");
        _desktop = new LineProcess("env", _server.Display, $"XDG_DATA_HOME={_folder}", "dotnet", program, "--size", "1200x760", "--scale", "1");
        Id = _server.Run("xdotool", "search", "--sync", "--onlyvisible", "--name", "CNC Engraver").Trim();
        _server.Run("xdotool", "windowactivate", "--sync", Id);
        _titles = new LineProcess("xprop", _server.Display, "-id", Id, "-spy", "_NET_WM_NAME");
    }

    /// <summary>The window's number on the server.</summary>
    public string Id { get; }

    public string Journals => Path.Combine(_folder, "CncEngraver", "journals");

    /// <summary>All titles so far.</summary>
    public IEnumerable<string> Titles => _titles.Lines;

    public ServerScreen Screen() => new(_screen.Path);

    /// <summary>Types words with Enter after each; nothing must have been clicked before.</summary>
    public void Enter(params ReadOnlySpan<string> words)
    {
        foreach (var word in words)
        {
            _server.Run("xdotool", "type", word);
            Press("Return");
        }
    }

    public void Type(string text) => _server.Run("xdotool", "type", text);

    /// <summary>Types words until the window has a title: commands for the machine are refused while another command runs, and an operator repeats
    /// them.</summary>
    public void EnterUntil(string beginning, params ReadOnlySpan<string> words)
    {
        for (var tries = 0; tries < 5; tries++)
        {
            Settle();
            Enter(words);
            if (_titles.PrintsWithin(Title(beginning), s_untilTypedAgain)) return;
            Press("Escape");
        }

        WaitForTitle(beginning);
    }

    /// <summary>Waits until painting has stopped and the program is idle: the last command has sent all its messages.</summary>
    public void Settle() => _ = Picture();

    public void Press(string key) => _server.Press(key);

    public void Click(Point place) => _server.Run("xdotool", "mousemove", "--window", Id, Whole(place.X), Whole(place.Y), "click", "1");

    /// <summary>Clicks until the window has a title: clicks during a running command are ignored, and an operator repeats them.</summary>
    public void ClickUntil(Point place, string beginning)
    {
        for (var tries = 0; tries < 10; tries++)
        {
            Click(place);
            if (_titles.PrintsWithin(Title(beginning), s_untilAgain)) return;
        }

        WaitForTitle(beginning);
    }

    /// <summary>Whether the window gets a title within some seconds.</summary>
    public bool HasTitleSoon(string beginning) => _titles.PrintsWithin(Title(beginning), s_untilTypedAgain);

    /// <summary>Presses the mouse button and keeps it down.</summary>
    public void HoldDown(Point place) => _server.Run("xdotool", "mousemove", "--window", Id, Whole(place.X), Whole(place.Y), "mousedown", "1");

    /// <summary>Drags files from another program to a position of the window and drops them there.</summary>
    /// <returns>True when the window took them.</returns>
    public bool Drop(Point place, params IEnumerable<string> paths)
    {
        using var other = new OtherProgram(_server);
        var corner = Corner();
        return other.Drop((nint)long.Parse(Id, CultureInfo.InvariantCulture), corner.X + (int)place.X, corner.Y + (int)place.Y, string.Concat(paths.Select(path => new Uri(path).AbsoluteUri + "\r\n")));
    }

    public void LetGo() => _server.Run("xdotool", "mouseup", "1");

    /// <summary>Kills the program; no more of its code runs.</summary>
    public void Kill()
    {
        _desktop.Kill();
        _desktop.WaitForExit();
    }

    /// <summary>The X server dies.</summary>
    public void LoseDisplay() => _server.Kill();

    public int WaitForExit() => _desktop.WaitForExit();

    /// <summary>The output of the program so far, standard output and errors.</summary>
    public IReadOnlyCollection<string> Output => _desktop.Lines;

    /// <summary>The picture of the window after it has come to rest, without the frame of the window manager.</summary>
    public byte[] Picture()
    {
        var (last, same) = (Screen(), 0);
        var work = new BusyThreads(_desktop.Id);
        using var looks = new PollingTimer(s_interval);
        for (var look = 0; look < MaxLooks && same < LooksAtRest; look++)
        {
            looks.WaitForNext();
            if (work.StillBusy())
            {
                same = 0; // the screen is not at its final state
                continue;
            }

            var now = Screen();
            same = now.Equals(last) ? same + 1 : 0;
            last = now;
        }

        return Screen().Png(new PixelRect(Corner(), Size));
    }

    /// <summary>Waits until a part of the window contains given pixels, with the pointer elsewhere.</summary>
    /// <param name="look">0xRRGGBB, row by row.</param>
    /// <param name="what">What is waited for, in words.</param>
    /// <exception cref="InvalidOperationException">It timed out; the actual picture of the window is stored with the results of the build.</exception>
    public void WaitForLook(PixelRect place, int[] look, string what)
    {
        _server.Run("xdotool", "mousemove", "--window", Id, "640", "17"); // beside the menus: the pointer is part of the picture
        var (corner, since) = (Corner(), Stopwatch.GetTimestamp());
        using var looks = new PollingTimer(s_interval);
        while (!Screen().Shows(new PixelRect(corner.X + place.X, corner.Y + place.Y, place.Width, place.Height), look))
        {
            looks.WaitForNext();
            if (Stopwatch.GetElapsedTime(since) < s_timeout) continue;
            KeepFailure();
            throw new InvalidOperationException($"The window does not show: {what}");
        }
    }

    /// <summary>The initial size of the desktop.</summary>
    public static PixelSize Size { get; } = new(1200, 760);

    /// <summary>Waits until the window has a title.</summary>
    /// <exception cref="InvalidOperationException">It timed out; the actual picture of the window is stored with the results of the build.</exception>
    public void WaitForTitle(string beginning)
    {
        try
        {
            _titles.WaitFor(Title(beginning));
        }
        catch (InvalidOperationException)
        {
            KeepFailure();
            throw;
        }
    }

    /// <summary>The name contains the process id, because two processes test real windows at a time.</summary>
    private void KeepFailure() => File.WriteAllBytes(Path.Combine(Pictures, string.Create(CultureInfo.InvariantCulture, $"failed-{Environment.ProcessId}.png")), Picture());

    /// <summary>The folder of pictures: that of ENGRAVER_PICTURES, otherwise that of the build results.</summary>
    public static string Pictures => Environment.GetEnvironmentVariable("ENGRAVER_PICTURES") ?? Directory.CreateDirectory(Path.Combine(RepositoryFolder.Root, "artifacts", "pictures")).FullName;

    /// <summary>The window's upper left corner on the screen, inside the frame of the window manager.</summary>
    public PixelPoint Corner()
    {
        var lines = _server.Run("xwininfo", "-id", Id).Split('\n');
        return new PixelPoint(Value("Absolute upper-left X:"), Value("Absolute upper-left Y:"));

        int Value(string name) => int.Parse(lines.Select(line => line.Trim()).First(line => line.StartsWith(name, StringComparison.Ordinal))[name.Length..], CultureInfo.InvariantCulture);
    }

    /// <summary>Closes the window by its key.</summary>
    /// <returns>The exit code of the program.</returns>
    public int Close()
    {
        Press("ctrl+q");
        return _desktop.WaitForExit();
    }

    public void Dispose()
    {
        _titles.Dispose();
        _desktop.Dispose();
        _server.Dispose();
        _screen.Dispose();
        _ownFolder?.Dispose();
    }

    private static string Title(string beginning) => $"_NET_WM_NAME(UTF8_STRING) = \"{beginning}";

    private static string Whole(double number) => Math.Round(number).ToString(CultureInfo.InvariantCulture);
}
