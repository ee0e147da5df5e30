using System.Globalization;
using Avalonia;
using Engraver.App.Tests.Start;
using Engraver.SoftwarePlatform.Tests.X11;

namespace Engraver.App.Tests.RealWindow;

/// <summary>The desktop as a process of its own on an X server, with a person before it. What it does is read off its title, as the task bar shows it.</summary>
internal sealed class ShownDesktop : IDisposable
{
    private readonly TemporaryDesktopFolder _folder = new();
    private readonly TemporaryDesktopFolder _screen = new();
    private readonly XServer _server;
    private readonly ToldProcess _desktop;
    private readonly ToldProcess _titles;

    public ShownDesktop()
    {
        _server = new XServer(screenFolder: _screen.Path);
        var program = Path.Combine(AppContext.BaseDirectory, "engraver-desktop.dll");
        _desktop = new ToldProcess("env", _server.Display, $"XDG_DATA_HOME={_folder.Path}", "dotnet", program, "--size", "1200x760", "--scale", "1");
        Id = _server.Run("xdotool", "search", "--sync", "--onlyvisible", "--name", "CNC Engraver").Trim();
        _server.Run("xdotool", "windowactivate", "--sync", Id);
        _titles = new ToldProcess("xprop", _server.Display, "-id", Id, "-spy", "_NET_WM_NAME");
    }

    /// <summary>The window's number on the server.</summary>
    public string Id { get; }

    public string Journals => Path.Combine(_folder.Path, "CncEngraver", "journals");

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

    public void Press(string key) => _server.Press(key);

    public void Click(Point place) => _server.Run("xdotool", "mousemove", "--window", Id, Whole(place.X), Whole(place.Y), "click", "1");

    /// <summary>Ends when the window is called so.</summary>
    public void WaitForTitle(string beginning) => _titles.WaitFor($"_NET_WM_NAME(UTF8_STRING) = \"{beginning}");

    /// <summary>Where the window's upper left corner stands on the screen.</summary>
    public PixelPoint Corner()
    {
        var lines = _server.Run("xdotool", "getwindowgeometry", "--shell", Id).Split('\n');
        return new PixelPoint(Value("X="), Value("Y="));

        int Value(string name) => int.Parse(lines.First(line => line.StartsWith(name, StringComparison.Ordinal))[name.Length..], CultureInfo.InvariantCulture);
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
        _folder.Dispose();
    }

    private static string Whole(double number) => Math.Round(number).ToString(CultureInfo.InvariantCulture);
}
