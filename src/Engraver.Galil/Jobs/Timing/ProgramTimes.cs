using Engraver.Core.Machines;
using Engraver.Galil.Language;
using Engraver.Galil.Programs.Posting;
using Engraver.Galil.Programs.Timing;

namespace Engraver.Galil.Jobs.Timing;

/// <summary>A job that runs in the controller: loading takes its bytes, both ways, because the download is read back, and after each chunk but the
/// first the spindle has to reach its speed again; then only the controller's own statements take time.</summary>
/// <param name="line">Null for a network, on which the time of loading is negligible.</param>
internal sealed class ProgramTimes(SerialLine? line) : DmcTimes
{
    /// <summary>Bytes exchanged around each chunk: both threads halted, DL and UL with their prompts, the variables, XQ, the query for the watchdog; the
    /// reply to the poll before it, and about half a poll until its end is seen by the first part of a poll, whose second part is still to
    /// come.</summary>
    private const int BytesAroundChunk = 290;

    /// <summary>Statements of a rapid: the line that assigns x and y and calls #RAPID, and the lines of that.</summary>
    private const int RapidStatements = 10;

    /// <summary>Statements of a tool change: SB or CB, and WT.</summary>
    private const int ToolStatements = 2;

    /// <summary>Statements of a move of the tool's axis (SP, PA, BG, AM), and as many around the subprogram that makes it.</summary>
    private const int HeightStatements = 4;

    /// <summary>Statements of a sequence: CSS, the mark, VM, VS, VE, BGS, JS#CUT and its five lines.</summary>
    private const int SequenceStatements = 12;

    public override double Loading(MotionProgram program)
    {
        var spinUp = program.Profile.Spindle?.SpinUpSeconds ?? 0.0;
        if (line is null && spinUp == 0.0) return 0.0;
        var frame = new ControllerFrame(program.Start, default);
        var chunks = new SupervisedProgram(program, frame, dryRun: false).Pack(program.Strokes, DmcLimits.ProgramLines, null).Chunks;
        var again = (chunks.Count - 1) * spinUp; // the spindle is off while the next chunk is loaded
        return line is null ? again : again + chunks.Sum(chunk => (BytesAroundChunk + (2.0 * chunk.Text.Length) + chunk.Text.AsSpan().Count('\n')) * line.ByteSeconds); // an upload ends each line with two characters
    }

    public override double Rapid(CountsPoint from, CountsPoint to, double moving, MotionProgram program) => RapidStatements * SecondsPerStatement;

    public override double Sequence(VectorSequence sequence, double moving, MotionProgram program) =>
        (SequenceStatements + Math.Min(sequence.Segments.Count, SequenceWriter.SentBeforeStart)) * SecondsPerStatement;

    public override double Wait(CountsPoint at, double seconds) => (DmcProfile.EvenMilliseconds(seconds) / 1000.0) + SecondsPerStatement;

    public override double Tool(CountsPoint at, bool on, double moving, MotionProgram program) => program.Profile.Height is null
        ? (program.Profile.SettleMilliseconds(on) / 1000.0) + (ToolStatements * SecondsPerStatement)
        : ((MovesOfTool(on) * HeightStatements) + HeightStatements) * SecondsPerStatement;
}
