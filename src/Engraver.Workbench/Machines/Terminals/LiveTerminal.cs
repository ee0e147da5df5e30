using Engraver.Core.Machines;

namespace Engraver.Workbench.Machines.Terminals;

/// <summary>The lines of the terminal page: what was typed, answered and printed, oldest first. They are kept after disconnecting.</summary>
/// <remarks>Any thread. Nothing is sent while a job runs, and lines that the driver withholds are not sent.</remarks>
public sealed class LiveTerminal
{
    /// <summary>Maximum number of lines; older ones are removed.</summary>
    private const int MaxLines = 2000;

    private readonly Lock _guard = new();
    private readonly List<TerminalEntry> _lines = [];
    private readonly TimeProvider _time;
    private readonly Func<string, CancellationToken, Task<IReadOnlyList<TerminalAnswer>>> _answer;

    internal LiveTerminal(TimeProvider time, Func<string, CancellationToken, Task<IReadOnlyList<TerminalAnswer>>> answer) => (_time, _answer) = (time, answer);

    /// <summary>Raised after lines were added; on any thread.</summary>
    public event EventHandler? Changed;

    public IReadOnlyList<TerminalEntry> Lines
    {
        get
        {
            lock (_guard) return [.. _lines];
        }
    }

    /// <summary>Sends a typed line and shows it with its answer.</summary>
    /// <exception cref="Engraver.Core.Machines.ControllerException">The link failed; the line remains on the page.</exception>
    public async Task<IReadOnlyList<TerminalAnswer>> TypeAsync(string line, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(line);
        Add(null, line.Trim());
        var answers = await _answer(line, cancellation).ConfigureAwait(false);
        foreach (var answer in answers) Add(answer.Kind, answer.Text);
        return answers;
    }

    internal void Add(TerminalAnswerKind? kind, string text)
    {
        lock (_guard)
        {
            _lines.Add(new TerminalEntry(_time.GetUtcNow(), kind, text));
            if (_lines.Count > MaxLines) _lines.RemoveRange(0, _lines.Count - MaxLines);
        }

        Changed?.Invoke(this, EventArgs.Empty);
    }
}
