using System.Globalization;
using Engraver.Core.Diagnostics;

namespace Engraver.Core.Posts.HpglReading;

/// <summary>Reads HP-GL/2 back and draws it as a plotter does, based only on the language reference (rs274-hpgl.md 3); shares no code with the post. A pen from
/// 1 to 8 that is in the holder and down is cutting.</summary>
/// <remarks>Commands that this reader does not support (labels, fills, encoded polylines) are findings, because they can draw. Only one command is in memory at
/// a time.</remarks>
public sealed class HpglReader : IProgramReader
{
    public bool ReportsHeights => false;

    /// <summary>The plotter's own unit: the rounding of both axes and the height of a chord move a point by no more than this.</summary>
    public double Rounding => 0.025;

    public Task<IReadOnlyList<Diagnostic>> ReplayAsync(TextReader text, ReplayRequest request, IProgress<ReplayProgress>? progress, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(text);
        ArgumentNullException.ThrowIfNull(request);
        var fault = Run(new HpglScanner(text), new HpglPlotter(request), cancellation);
        return Task.FromResult<IReadOnlyList<Diagnostic>>(fault is null ? [] : [fault]);
    }

    private static Diagnostic? Run(HpglScanner scanner, HpglPlotter plotter, CancellationToken cancellation)
    {
        while (scanner.Next(out var reason) is var command)
        {
            cancellation.ThrowIfCancellationRequested();
            if (reason.Length > 0) return Fault(scanner.Line, reason);
            if (command is null) break;
            if (plotter.Execute(command) is { } fault) return Fault(command.Line, fault);
        }

        plotter.End(scanner.Line);
        if (!plotter.HasMoved) return VerificationRules.ProgramEmpty.At(default);
        return plotter.IsDown ? Fault(scanner.Line, Wording.Get("HpglReader.EndsWithPenDown")) : null;
    }

    private static Diagnostic Fault(int line, string reason) => PostRules.BlockUnreadable.At(new SourceRef(line), line.ToString(CultureInfo.InvariantCulture), reason);
}
