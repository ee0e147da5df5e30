using Engraver.Core.Drawings;
using Engraver.Core.Languages;
using Engraver.Tools.CrossChecks;

namespace Engraver.Cli.Output;

/// <summary>Compares a drawing with a second reading of its file and reports the differences.</summary>
internal static class CrossCheckReport
{
    /// <summary>Writes one line for each difference, or one line that states that there are none.</summary>
    /// <returns>False when the two readings differ, or the second one could not be made.</returns>
    public static bool Write(TextWriter error, Drawing read, DrawingSummary summary)
    {
        try
        {
            var differences = CrossCheck.Read(File.ReadAllBytes(read.FileName)).DifferencesFrom(summary);
            foreach (var difference in differences) error.WriteLine(Wording.Get("CrossCheckReport.Differs", read.FileName, difference));
            if (differences.Count == 0) error.WriteLine(Wording.Get("CrossCheckReport.Agrees", read.FileName));
            return differences.Count == 0;
        }
        catch (CrossCheckException beyond)
        {
            error.WriteLine(Wording.Get("CrossCheckReport.NotSupported", read.FileName, beyond.Message));
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException)
        {
            error.WriteLine(Wording.Get("CrossCheckReport.CannotReread", read.FileName, SystemErrorText.FromException(unreadable)));
        }

        return false;
    }
}
