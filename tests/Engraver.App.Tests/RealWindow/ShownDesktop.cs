using System.Diagnostics;
using System.Globalization;
using Avalonia;
using Engraver.App.Tests.Start;
using Engraver.SoftwarePlatform.Tests.X11;
using Engraver.TestKit;

namespace Engraver.App.Tests.RealWindow;

/// <summary>The desktop as a process of its own on an X server, with a person before it. What it does is read off its title, as the task bar shows
/// it.</summary>
internal sealed class ShownDesktop : IDisposable
{
    private readonly TemporaryDesktopFolder? _ownFolder;
    private readonly string _folder;
    private readonly TemporaryDesktopFolder _screen = new();
    private static readonly TimeSpan s_untilAgain = TimeSpan.FromSeconds(3);
    private static readonly TimeSpan s_untilTypedAgain = TimeSpan.FromSeconds(10);
    private static readonly TimeSpan s_patience = TimeSpan.FromSeconds(60); // only a broken test waits that long

    /// <summary>Two frames of the screen: looking more often takes the time of the processor from what is waited for.</summary>
    private static readonly TimeSpan s_look = TimeSpan.FromMilliseconds(33);

    /// <summary>A window that looks the same so often, while its program has nothing to do, has nothing left to paint; the caret blinks every half
    /// second.</summary>
    private const int LooksAtRest = 14;

    /// <summary>Four seconds: a program that is at work for longer is not waited for.</summary>
    private const int MostLooks = 120;

    private readonly XServer _server;
    private readonly ToldProcess _desktop;
    private readonly ToldProcess _titles;

    /// <param name="folder">Where the operator's files are, which another desktop may have left there; null: a new one.</param>
    public ShownDesktop(string? folder = null)
    {
        _ownFolder = folder is null ? new TemporaryDesktopFolder() : null;
        _folder = folder ?? _ownFolder!.Path;
        _server = new XServer(screenFolder: _screen.Path);
        var program = Path.Combine(AppContext.BaseDirectory, "engraver-desktop.dll");
        _desktop = new ToldProcess("env", _server.Display, $"XDG_DATA_HOME={_folder}", "dotnet", program, "--size", "1200x760", "--scale", "1");
        Id = _server.Run("xdotool", "search", "--sync", "--onlyvisible", "--name", "CNC Engraver").Trim();
        _server.Run("xdotool", "windowactivate", "--sync", Id);
        _titles = new ToldProcess("xprop", _server.Display, "-id", Id, "-spy", "_NET_WM_NAME");
    }

    /// <summary>The window's number on the server.</summary>
    public string Id { get; }

    public string Journals => Path.Combine(_folder, "CncEngraver", "journals");

    /// <summary>Every title so far.</summary>
    public IEnumerable<string> Titles => _titles.Heard;

    public ServerScreen Screen() => new(_screen.Path);

    /// <summary>Types words with Enter after each; nothing was clicked before.</summary>
    public void Enter(params ReadOnlySpan<string> words)
    {
        foreach (var word in words)
        {
            _server.Run("xdotool", "type", word);
            Press("Return");
        }
    }

    public void Type(string text) => _server.Run("xdotool", "type", text);

    /// <summary>Types words until the window is called so: what acts on the machine is refused while a command is at work, and an operator types it
    /// again.</summary>
    public void EnterUntil(string beginning, params ReadOnlySpan<string> words)
    {
        for (var tries = 0; tries < 5; tries++)
        {
            Settle();
            Enter(words);
            if (_titles.HearsWithin(Title(beginning), s_untilTypedAgain)) return;
            Press("Escape");
        }

        WaitForTitle(beginning);
    }

    /// <summary>Waits until nothing is painted any more and the program has nothing to do: the last command has said all that it says.</summary>
    public void Settle() => _ = Picture();

    public void Press(string key) => _server.Press(key);

    public void Click(Point place) => _server.Run("xdotool", "mousemove", "--window", Id, Whole(place.X), Whole(place.Y), "click", "1");

    /// <summary>Clicks until the window is called so: what is clicked while a command is at work is not heard, and an operator clicks again.</summary>
    public void ClickUntil(Point place, string beginning)
    {
        for (var tries = 0; tries < 10; tries++)
        {
            Click(place);
            if (_titles.HearsWithin(Title(beginning), s_untilAgain)) return;
        }

        WaitForTitle(beginning);
    }

    /// <summary>Whether the window is called so within some seconds.</summary>
    public bool IsCalledSoon(string beginning) => _titles.HearsWithin(Title(beginning), s_untilTypedAgain);

    /// <summary>Presses the mouse button and keeps it down.</summary>
    public void HoldDown(Point place) => _server.Run("xdotool", "mousemove", "--window", Id, Whole(place.X), Whole(place.Y), "mousedown", "1");

    /// <summary>Drags files from another program over a place of the window and lets go there.</summary>
    /// <returns>True when the window took them.</returns>
    public bool Drop(Point place, params IEnumerable<string> paths)
    {
        using var other = new OtherProgram(_server);
        var corner = Corner();
        return other.Drop((nint)long.Parse(Id, CultureInfo.InvariantCulture), corner.X + (int)place.X, corner.Y + (int)place.Y, string.Concat(paths.Select(path => new Uri(path).AbsoluteUri + "\r\n")));
    }

    public void LetGo() => _server.Run("xdotool", "mouseup", "1");

    /// <summary>The program dies at once: nothing of it is run any more.</summary>
    public void Kill()
    {
        _desktop.Kill();
        _desktop.WaitForExit();
    }

    /// <summary>The X server dies.</summary>
    public void LoseDisplay() => _server.Kill();

    public int WaitForExit() => _desktop.WaitForExit();

    /// <summary>What the program has said so far, on both outputs.</summary>
    public IReadOnlyCollection<string> Heard => _desktop.Heard;

    /// <summary>What the operator sees when the window has come to rest, without the frame of the window manager.</summary>
    public byte[] Picture()
    {
        var (last, same) = (Screen(), 0);
        var work = new ThreadsAtWork(_desktop.Id);
        using var looks = new Looks(s_look);
        for (var look = 0; look < MostLooks && same < LooksAtRest; look++)
        {
            looks.Next();
            if (work.GoOn())
            {
                same = 0; // what stands on the screen is not the last of it
                continue;
            }

            var now = Screen();
            same = now.Equals(last) ? same + 1 : 0;
            last = now;
        }

        return Screen().Png(new PixelRect(Corner(), Size));
    }

    /// <summary>Ends when a part of the window looks so, with the pointer elsewhere.</summary>
    /// <param name="look">0xRRGGBB, row by row.</param>
    /// <param name="what">What is waited for, in words.</param>
    /// <exception cref="InvalidOperationException">It never did; what the window showed instead is kept with the results of the build.</exception>
    public void WaitForLook(PixelRect place, int[] look, string what)
    {
        _server.Run("xdotool", "mousemove", "--window", Id, "640", "17"); // beside the menus: the pointer is part of the picture
        var (corner, since) = (Corner(), Stopwatch.GetTimestamp());
        using var looks = new Looks(s_look);
        while (!Screen().Shows(new PixelRect(corner.X + place.X, corner.Y + place.Y, place.Width, place.Height), look))
        {
            looks.Next();
            if (Stopwatch.GetElapsedTime(since) < s_patience) continue;
            KeepFailure();
            throw new InvalidOperationException($"The window does not show: {what}");
        }
    }

    /// <summary>The size that the desktop is started with.</summary>
    public static PixelSize Size { get; } = new(1200, 760);

    /// <summary>Ends when the window is called so.</summary>
    /// <exception cref="InvalidOperationException">It never was; what the window showed instead is kept with the results of the build.</exception>
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

    /// <summary>Named by the process: two of them try real windows at a time.</summary>
    private void KeepFailure() => File.WriteAllBytes(Path.Combine(Pictures, string.Create(CultureInfo.InvariantCulture, $"failed-{Environment.ProcessId}.png")), Picture());

    /// <summary>Where pictures are kept: in the folder of ENGRAVER_PICTURES, else with the results of the build.</summary>
    public static string Pictures => Environment.GetEnvironmentVariable("ENGRAVER_PICTURES") ?? Directory.CreateDirectory(Path.Combine(RepositoryFolder.Root, "artifacts", "pictures")).FullName;

    /// <summary>Where the window's upper left corner stands on the screen, inside the frame of the window manager.</summary>
    public PixelPoint Corner()
    {
        var lines = _server.Run("xwininfo", "-id", Id).Split('\n');
        return new PixelPoint(Value("Absolute upper-left X:"), Value("Absolute upper-left Y:"));

        int Value(string name) => int.Parse(lines.Select(line => line.Trim()).First(line => line.StartsWith(name, StringComparison.Ordinal))[name.Length..], CultureInfo.InvariantCulture);
    }

    /// <summary>Closes the window with its key.</summary>
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
