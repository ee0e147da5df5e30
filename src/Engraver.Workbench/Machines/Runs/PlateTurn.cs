using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Workbench.SerialTexts;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>The run of one plate of a series: its numbers are spent right before the job takes the machine, and confirmed when it is complete.</summary>
/// <param name="Book">Null: nothing is spent, as for a dry run.</param>
/// <param name="IsResumed">The numbers are those of an interrupted run.</param>
public sealed record PlateTurn(Plate Plate, IReadOnlyList<CounterDesign> Designs, CounterBook? Book, CounterChoice Choice, bool IsResumed) : IDisposable
{
    private SpentPlate? _spent;

    /// <summary>Spends the numbers.</summary>
    /// <returns>Why the plate must not start; null if it may.</returns>
    public async Task<Diagnostic?> StartAsync(string drawing, string journal, CancellationToken stop)
    {
        if (Book is null) return null;
        try
        {
            _spent = IsResumed ? await Book.ResumeAsync(Plate.Values, Choice, drawing, journal, stop).ConfigureAwait(false) : await Book.SpendAsync(Designs, Plate.Values, Choice, drawing, journal, stop).ConfigureAwait(false);
            return null;
        }
        catch (CounterException refused) when (refused.Finding is not null)
        {
            return refused.Finding;
        }
    }

    /// <summary>Confirms the numbers of a complete plate, and gives them back if the job ended before it took the machine. Otherwise the plate remains
    /// unfinished.</summary>
    /// <returns>A warning if that could not be written.</returns>
    public async Task<Diagnostic?> EndAsync(MachineRunReport report)
    {
        if (_spent is null) return null;
        if (report.Result.Outcome == JobOutcome.Complete) return await _spent.ConfirmAsync(CancellationToken.None).ConfigureAwait(false);
        return report.Result.FrameOrigin is null ? await _spent.ReleaseAsync(CancellationToken.None).ConfigureAwait(false) : null;
    }

    public void Dispose() => _spent?.Dispose();
}
