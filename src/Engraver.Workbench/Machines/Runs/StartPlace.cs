using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Machines;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>Where a job would be cut, held against where the last run of its drawing on the same controller was.</summary>
public static class StartPlace
{
    /// <summary>The drawing's file as the memory knows it.</summary>
    public static string FileOf(Drawing drawing) => drawing.FileName is { Length: > 0 } name ? Path.GetFullPath(name) : "";

    /// <summary>The controller counts at which the job's start lay in an earlier run.</summary>
    public static CountsPoint Locate(RunStart last, DrawingSettings settings)
    {
        var start = settings.Machine.Scale.ToCounts(settings.Start);
        return new CountsPoint(last.FrameX + start.X, last.FrameY + start.Y);
    }

    /// <summary>The finding when a job that begins here is cut elsewhere than the last one; null when it is cut in the same place, to a count.</summary>
    /// <param name="last">Null when there was none.</param>
    /// <param name="here">Controller counts where the machine stands, which are taken for the job's start.</param>
    public static Diagnostic? Compare(RunStart? last, PreparedJob job, CountsPoint here)
    {
        if (last is null) return null;
        var there = Locate(last, job.Settings);
        var (dx, dy) = ((double)here.X - there.X, (double)here.Y - there.Y);
        if (Math.Abs(dx) <= 1.0 && Math.Abs(dy) <= 1.0) return null;
        var scale = job.Settings.Machine.Scale;
        var when = last.At.ToString("yyyy-MM-dd HH:mm 'UTC'", CultureInfo.InvariantCulture);
        return PreparationRules.StartsElsewhere.At(default, Place(here, scale), PointPrompt.Show(job.Settings.Start), when, Place(there, scale), Number(dx / scale.X), Number(dy / scale.Y));
    }

    /// <summary>Compares a job that is about to move and remembers its start for the next one.</summary>
    /// <param name="controller">Where the controller is reached.</param>
    /// <param name="header">Of the journal: where the machine stands, and the frame of the job.</param>
    public static IEnumerable<Diagnostic> Begin(StartMemory memory, string controller, PreparedJob job, JournalHeader header)
    {
        if (Compare(memory.Last(controller, FileOf(job.Drawing)), job, new CountsPoint(header.StartX, header.StartY)) is { } elsewhere) yield return elsewhere;
        if (Remembered(memory, new RunStart(controller, FileOf(job.Drawing), header.FrameX, header.FrameY, header.StartedAt)) is { } forgotten) yield return forgotten;
    }

    private static Diagnostic? Remembered(StartMemory memory, RunStart start)
    {
        try
        {
            memory.Remember(start);
            return null;
        }
        catch (Exception failure) when (failure is IOException or UnauthorizedAccessException)
        {
            return PreparationRules.StartNotKept.At(default, failure.Message.TrimEnd('.'));
        }
    }

    private static string Place(CountsPoint at, CountsScale scale) => $"{Number(at.X / scale.X)}, {Number(at.Y / scale.Y)}";

    private static string Number(double value) => value.ToString("0.###", CultureInfo.InvariantCulture);
}
