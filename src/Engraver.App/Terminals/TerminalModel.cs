using Avalonia.Threading;
using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.Galil.Protocol;
using Engraver.Workbench.Terminals;

namespace Engraver.App.Terminals;

/// <summary>The conversation with the controller, line by line.</summary>
public sealed class TerminalModel : Observable
{
    private readonly WorkDesk _desk;
    private string _line = "";
    private int _waiting;

    public TerminalModel(WorkDesk desk)
    {
        _desk = desk;
        Terminal.Changed += (_, _) => Post();
        Look();
    }

    /// <summary>What was typed and answered, oldest first.</summary>
    public IReadOnlyList<TerminalRow> Rows { get; private set; } = [];

    public string Line
    {
        get => _line;
        set => Set(ref _line, value ?? "");
    }

    private LiveTerminal Terminal => _desk.Session.Machine.Terminal;

    /// <summary>Enter: the line goes to the controller. A link that fails is an alarm; the line stays on the page.</summary>
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
            Look();
        }
    }

    private void Post()
    {
        if (Interlocked.Exchange(ref _waiting, 1) == 0) Dispatcher.UIThread.Post(Look, DispatcherPriority.Input);
    }

    private void Look()
    {
        Volatile.Write(ref _waiting, 0);
        Rows = [.. Terminal.Lines.SelectMany(TerminalRow.Of)];
        Tell(nameof(Rows));
    }
}
