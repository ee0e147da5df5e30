using Engraver.Core.Diagnostics;

namespace Engraver.Core.Posts;

/// <summary>Reads a posted text back and runs it in an interpreter that shares no code with the post.</summary>
public interface IProgramReader
{
    /// <summary>False for a format without heights: its cuts are compared in plan, independent of the tool drive of the machine.</summary>
    bool ReportsHeights => true;

    /// <summary>True when the reported times are those of the machine and not only an order.</summary>
    bool ReportsTimes => false;

    /// <summary>True for a format in which the posts of this program round corners within the corner tolerance.</summary>
    bool RoundsCorners => false;

    /// <summary>Largest rounding of a position in the format, millimetres; it is added to the allowed deviation.</summary>
    double Rounding => 0.0;

    /// <summary>Passes every motion from the first command to the end of the program to the judges. The text is read once, and only one command, line or part
    /// that is loaded at once is in memory: memory does not grow with the length of the text.</summary>
    /// <returns>The reasons, with lines, why the text is not a program or did not run to its end; empty on success.</returns>
    /// <exception cref="OperationCanceledException">The operation was cancelled.</exception>
    /// <exception cref="IOException">Reading the text fails.</exception>
    /// <exception cref="InvalidDataException">The text has a line that is too long for any program.</exception>
    Task<IReadOnlyList<Diagnostic>> ReplayAsync(TextReader text, ReplayRequest request, IProgress<ReplayProgress>? progress, CancellationToken cancellation);
}
