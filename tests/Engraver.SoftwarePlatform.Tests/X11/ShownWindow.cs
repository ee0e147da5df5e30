using System.Globalization;

namespace Engraver.SoftwarePlatform.Tests.X11;

/// <summary>The demo window in a separate process, shown and active, and the positions of its controls.</summary>
internal sealed class ShownWindow : IDisposable
{
    public ShownWindow(XServer server, double scale = 1.0)
    {
        Program = new LineProcess("dotnet", server.Display, typeof(ShownWindow).Assembly.Location, scale.ToString(CultureInfo.InvariantCulture));
        Program.WaitFor("active");
        Program.Send("where");
        Counter = Place(Program.WaitFor("at counter"));
        Entry = Place(Program.WaitFor("at entry"));
        Rows = Place(Program.WaitFor("at rows"));
        Id = Program.WaitFor("window").Split(' ')[1];
    }

    public LineProcess Program { get; }

    public (int X, int Y) Counter { get; }

    public (int X, int Y) Entry { get; }

    public (int X, int Y) Rows { get; }

    /// <summary>The window's number on the server.</summary>
    public string Id { get; }

    public void Dispose() => Program.Dispose();

    private static (int X, int Y) Place(string line)
    {
        var words = line.Split(' ');
        return (int.Parse(words[2], CultureInfo.InvariantCulture), int.Parse(words[3], CultureInfo.InvariantCulture));
    }
}
