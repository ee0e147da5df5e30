using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Galil.Language;
using static Engraver.Galil.Programs.Subprograms;

namespace Engraver.Galil.Programs.Posting;

/// <summary>Spells the strokes of a motion program as vector sequences, several segments a line.</summary>
internal sealed class SequenceWriter(MachineProfile profile, ControllerFrame frame, SequenceSpelling spelling)
{
    /// <summary>Buffered before the machine starts; the rest follows while it moves.</summary>
    internal const int SentBeforeStart = 480;

    /// <summary>Between two looks at the buffer no more segments are sent than #ROOM has waited for.</summary>
    private const int RoomWaitedFor = 50;

    /// <summary>Waits until the buffer has room (never tests for equality: what an empty buffer reads differs between manuals, galil-dmc.md 0.3).</summary>
    /// <param name="check">Statement before each look, or empty.</param>
    public static IReadOnlyList<string> RoomLines(string check) => new ProgramLines().Line("#ROOM").Line(check).Line(Text($"JP#ROOM,_LMS<{RoomWaitedFor}")).Line("EN").Lines;

    /// <summary>Rapid, sequences, tool off. The tool goes on when the first sequence is in the buffer, so that it does not burn a spot meanwhile.</summary>
    public IReadOnlyList<string> Stroke(MotionStroke stroke)
    {
        var lines = new ProgramLines().Line(spelling.Rapid(frame.Of(stroke.Start)));
        for (var i = 0; i < stroke.Sequences.Count; i++) Sequence(lines, stroke.Sequences[i], i == 0 ? spelling.ToolOn(frame.Of(stroke.Start)) : []);
        return lines.Line([.. spelling.ToolOff]).Lines;
    }

    /// <summary>A number of lines that <see cref="Stroke"/> does not exceed: a line for each segment, one before and one behind the sequence, and in one
    /// that is longer than the buffer a wait before each line.</summary>
    public static int MostLines(MotionStroke stroke)
    {
        var lines = 2;
        for (var i = 0; i < stroke.Sequences.Count; i++) lines += stroke.Sequences[i].Segments.Count is > SentBeforeStart and var many ? 3 + (2 * many) : 2 + stroke.Sequences[i].Segments.Count;
        return lines;
    }

    private void Sequence(ProgramLines lines, VectorSequence sequence, IReadOnlyList<string> toolOn)
    {
        lines.Line(spelling.Open, sequence.ChangesHeight ? "LM" + profile.Axes.Letters : "VM" + profile.Axes.PlaneLetters, Text($"VS {sequence.Speed}"));
        var (sent, sinceRoom, started) = (0, 0, false);
        foreach (var group in Groups(sequence))
        {
            if (!started && sent + group.Count > SentBeforeStart)
            {
                lines.Line([.. toolOn, "BGS"]);
                (started, sinceRoom) = (true, RoomWaitedFor);
            }

            if (started && sinceRoom + group.Count > RoomWaitedFor)
            {
                lines.Line("JS#ROOM");
                sinceRoom = 0;
            }

            lines.Line([.. group]);
            (sent, sinceRoom) = (sent + group.Count, sinceRoom + group.Count);
        }

        string[] ending = started ? ["VE", spelling.AwaitEnd] : ["VE", .. toolOn, "BGS", spelling.AwaitEnd];
        lines.Line(ending);
    }

    /// <summary>The segments' commands, as many together as a line holds.</summary>
    private IEnumerable<List<string>> Groups(VectorSequence sequence)
    {
        var group = new List<string>();
        var length = -1;
        foreach (var command in DmcFormat.Commands(sequence, profile.Axes))
        {
            if (length + 1 + command.Length > DmcLimits.LineLength)
            {
                yield return group;
                group = [];
                length = -1;
            }

            group.Add(command);
            length += 1 + command.Length;
        }

        yield return group;
    }
}

/// <summary>From the job's frame to the controller's own coordinates, which rapids (PA) need: both meet where the machine stands when the job starts.</summary>
/// <param name="JobStart">That place in the job's frame.</param>
/// <param name="ControllerAtStart">What the controller's position reads there.</param>
public readonly record struct ControllerFrame(CountsPoint JobStart, CountsPoint ControllerAtStart)
{
    /// <summary>True when the controller can count to this place of the job's frame.</summary>
    public bool Holds(CountsPoint job) => Holds(job, 0) && Holds(job, 1) && Holds(job, 2);

    /// <summary>Throws <see cref="OverflowException"/> when the controller could not count that far from where it stands.</summary>
    public CountsPoint Of(CountsPoint job) => new(
        checked((int)(job.X - JobStart.X + ControllerAtStart.X)),
        checked((int)(job.Y - JobStart.Y + ControllerAtStart.Y)),
        HeightOf(job.Z));

    /// <summary>The same of a height alone.</summary>
    public int HeightOf(int job) => checked((int)((long)job - JobStart.Z + ControllerAtStart.Z));

    /// <summary>True when the controller can count to every place of these extents.</summary>
    public bool Holds(MotionExtents job) => Holds(new CountsPoint(job.LeastX, job.LeastY)) && Holds(new CountsPoint(job.MostX, job.MostY));

    private bool Holds(CountsPoint job, int axis) => Math.Abs(job[axis] - JobStart[axis] + ControllerAtStart[axis]) <= int.MaxValue;
}

/// <summary>Where two ways of writing vector sequences differ.</summary>
/// <param name="Open">Statements before VM; may be empty.</param>
/// <param name="AwaitEnd">The statement that waits for the end of the sequence.</param>
/// <param name="Rapid">The line that travels to a place in the controller's coordinates, tool off, and waits.</param>
/// <param name="ToolOn">The statements that bring the tool to a place in the controller's coordinates; empty for a dry run of a tool that is switched.</param>
/// <param name="ToolOff">The statements that take it away.</param>
internal sealed record SequenceSpelling(string Open, string AwaitEnd, Func<CountsPoint, string> Rapid, Func<CountsPoint, IReadOnlyList<string>> ToolOn, IReadOnlyList<string> ToolOff)
{
    /// <summary>The statements of the profile's tool drive: the output with its settle, or the subprograms that move the axis.</summary>
    /// <param name="height">Spells a height of the controller.</param>
    public static (Func<CountsPoint, IReadOnlyList<string>> On, IReadOnlyList<string> Off) ToolOf(MachineProfile profile, bool dryRun, Func<int, string> height) => profile.Height is null
        ? (_ => dryRun ? [] : [Subprograms.ToolOn(profile), Settle(profile)], [Subprograms.ToolOff(profile), Settle(profile, on: false)])
        : (place => [$"z={height(place.Z)}", "JS" + Down], ["JS" + Up]);
}
