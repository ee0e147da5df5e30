using System.Globalization;
using Engraver.Core.Diagnostics;

namespace Engraver.Core.Posts.GcodeReading;

/// <summary>Reads G-code back and runs it as the controller does, based only on the documentation of the controller (rs274-hpgl.md 1 and 2); shares no code
/// with the post.</summary>
/// <remarks>A line that the controller would refuse, or that would move to a position that the program does not state, is one finding, and the rest is not run.
/// Only one line is in memory at a time.</remarks>
public sealed class GcodeReader(GcodeController controller = GcodeController.LinuxCnc) : IProgramReader
{
    public Task<IReadOnlyList<Diagnostic>> ReplayAsync(TextReader text, ReplayRequest request, IProgress<ReplayProgress>? progress, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(text);
        ArgumentNullException.ThrowIfNull(request);
        var fault = Run(new ProgramRows(text), new GcodeMachine(request, controller), cancellation);
        return Task.FromResult<IReadOnlyList<Diagnostic>>(fault is null ? [] : [fault]);
    }

    private Diagnostic? Run(ProgramRows lines, GcodeMachine machine, CancellationToken cancellation)
    {
        var (hasBegun, isMarked) = (false, false);
        while (lines.Next() is { } row)
        {
            cancellation.ThrowIfCancellationRequested();
            var line = lines.Number;
            if (GcodeBlock.Parse(row, out var reason) is not { } block) return Fault(line, reason);
            if (block.IsMark)
            {
                if (controller == GcodeController.Grbl || hasBegun) return Fault(line, Wording.Get("GcodeReader.MarkNotAllowed"));
                (hasBegun, isMarked) = (true, true);
                continue;
            }

            if (block.Words.Count == 0) continue;
            hasBegun = true;
            if ((GcodeRules.Check(block, controller) ?? machine.Execute(block, line)) is { } fault) return Fault(line, fault);
            if (machine.HasEnded) return Rest(lines, isMarked) ?? (machine.HasMoved ? null : VerificationRules.ProgramEmpty.At(default));
        }

        return hasBegun ? Fault(lines.Number, Wording.Get("GcodeReader.NoEnd")) : VerificationRules.ProgramEmpty.At(default);
    }

    /// <summary>After the end only the mark is allowed, if the program started with one: any other text would not be run and is not part of a complete
    /// program.</summary>
    private static Diagnostic? Rest(ProgramRows lines, bool isMarked)
    {
        while (lines.Next() is { } row)
        {
            var text = row.Trim();
            if (text == "%" && isMarked) return null;
            if (text.Length > 0) return Fault(lines.Number, Wording.Get("GcodeReader.TextAfterEnd"));
        }

        return isMarked ? Fault(lines.Number, Wording.Get("GcodeReader.EndMarkMissing")) : null;
    }

    private static Diagnostic Fault(int line, string reason) => PostRules.BlockUnreadable.At(new SourceRef(line), line.ToString(CultureInfo.InvariantCulture), reason);
}
