using System.Globalization;
using Avalonia.Threading;
using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.Core.Machines;
using Engraver.Workbench.Machines.Terminals;

namespace Engraver.App.Terminals;

/// <summary>The conversation with the controller, line by line.</summary>
public sealed class TerminalModel : ObservableObject
{
    private readonly DesktopModel _desk;
    private string _line = "";
    private int _waiting;

    public TerminalModel(DesktopModel desk)
    {
        _desk = desk;
        Terminal.Changed += (_, _) => Post();
        Refresh();
    }

    /// <summary>Inputs and replies, oldest first.</summary>
    public IReadOnlyList<TerminalRow> Rows { get; private set; } = [];

    public string Line
    {
        get => _line;
        set => SetProperty(ref _line, value ?? "");
    }

    private LiveTerminal Terminal => _desk.Session.Machine.Connection.Terminal;

    /// <summary>Enter: sends the line to the controller. A failing link raises an alarm; the line stays on the page.</summary>
    public async Task SubmitAsync()
    {
        var line = Line;
        Line = "";
        try
        {
            await Task.Run(() => Terminal.TypeAsync(line, CancellationToken.None));
        }
        catch (ControllerException)
        {
            Refresh();
        }
    }

    private void Post()
    {
        if (Interlocked.Exchange(ref _waiting, 1) == 0) Dispatcher.UIThread.Post(Refresh, DispatcherPriority.Input);
    }

    private void Refresh()
    {
        Volatile.Write(ref _waiting, 0);
        Rows = [.. Terminal.Lines.SelectMany(entry => TerminalRow.From(entry, _desk.Time.LocalTimeZone))];
        OnPropertyChanged(nameof(Rows));
    }
}

/// <summary>A line of the conversation with the controller.</summary>
public sealed record TerminalRow(string Time, string Text, bool IsTyped, bool IsRefusal, bool IsQuiet)
{
    public static IEnumerable<TerminalRow> From(TerminalEntry entry, TimeZoneInfo zone)
    {
        var time = TimeZoneInfo.ConvertTime(entry.Time, zone).ToString("HH:mm:ss.fff", CultureInfo.InvariantCulture);
        foreach (var line in entry.Text.Split('\n'))
        {
            yield return new TerminalRow(time, entry.Kind is null ? "> " + line : line, entry.Kind is null, entry.Kind is TerminalAnswerKind.Refusal or TerminalAnswerKind.Withheld, entry.Kind is TerminalAnswerKind.Help or TerminalAnswerKind.Message);
        }
    }
}
