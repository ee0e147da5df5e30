using Engraver.Core.Machines;
using Engraver.Galil.Language;
using static Engraver.Galil.Programs.Subprograms;

namespace Engraver.Galil.Programs.Posting;

/// <summary>Writes the strokes of a motion program as vector sequences, several segments a line.</summary>
internal sealed class SequenceWriter(MachineProfile profile, ControllerFrame frame, SequenceSyntax spelling)
{
    /// <summary>Number of segments buffered before the machine starts; the rest follows while it moves.</summary>
    internal const int SentBeforeStart = 480;

    /// <summary>Maximum number of segments sent between two tests of the buffer; #ROOM has waited for as many free places.</summary>
    private const int RoomWaitedFor = 50;

    /// <summary>Waits until the buffer has room. The test never uses equality, because the value for an empty buffer differs between manuals (galil-dmc.md
    /// 0.3).</summary>
    /// <param name="check">Statement before each test, or empty.</param>
    public static IReadOnlyList<string> RoomLines(string check) => new ProgramLines().Line("#ROOM").Line(check).Line(DmcFormat.Text($"JP#ROOM,_LMS<{RoomWaitedFor}")).Line("EN").Lines;

    /// <summary>Outputs of the operation, rapid, sequences, tool off. The tool is switched on when the first sequence is in the buffer, so that it does not
    /// burn a spot meanwhile.</summary>
    public IReadOnlyList<string> Stroke(MotionStroke stroke)
    {
        var lines = new ProgramLines().Line(spelling.Ready(stroke.Terms)).Line(spelling.Rapid(frame.Of(stroke.Start)));
        for (var i = 0; i < stroke.Sequences.Count; i++) Sequence(lines, stroke.Sequences[i], i == 0 ? spelling.ToolOn(frame.Of(stroke.Start), stroke.Terms) : []);
        return lines.Line([Wait(stroke.Terms?.DwellSeconds ?? 0.0), .. spelling.ToolOff]).Lines;
    }

    /// <summary>Upper bound of the number of lines of <see cref="Stroke"/>: a line for each segment, one before and one after the sequence, one that sets
    /// outputs, and in a sequence longer than the buffer a wait before each line.</summary>
    public static int MaxLines(MotionStroke stroke)
    {
        var lines = stroke.Terms is { SetsOutputs: true } ? 3 : 2;
        for (var i = 0; i < stroke.Sequences.Count; i++) lines += stroke.Sequences[i].Segments.Count is > SentBeforeStart and var many ? 3 + (2 * many) : 2 + stroke.Sequences[i].Segments.Count;
        return lines;
    }

    private void Sequence(ProgramLines lines, VectorSequence sequence, IReadOnlyList<string> toolOn)
    {
        var acceleration = sequence.AccelerationOn(profile);
        lines.Line(spelling.Open, sequence.ChangesHeight ? "LM" + profile.Axes.Letters : "VM" + profile.Axes.PlaneLetters, DmcFormat.Text($"VS {sequence.Speed}"), DmcFormat.Text($"VA {acceleration}"), DmcFormat.Text($"VD {acceleration}"));
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

    /// <summary>The commands of the segments, as many as fit in one line.</summary>
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

/// <summary>The differences between two ways of writing vector sequences.</summary>
/// <param name="Open">Statements before VM; may be empty.</param>
/// <param name="AwaitEnd">The statement that waits for the end of the sequence.</param>
/// <param name="Rapid">The line that travels to a position in the controller's coordinates, tool off, and waits.</param>
/// <param name="ToolOn">The statements that bring the tool to a position in the controller's coordinates; empty for a dry run of a switched tool.
/// With its wait before the first move.</param>
/// <param name="ToolOff">The statements that raise the tool or switch it off.</param>
/// <param name="Ready">The statements before a rapid that set the outputs of the operation.</param>
internal sealed record SequenceSyntax(string Open, string AwaitEnd, Func<CountsPoint, string> Rapid, Func<CountsPoint, StrokeTerms?, IReadOnlyList<string>> ToolOn, IReadOnlyList<string> ToolOff, Func<StrokeTerms?, string[]> Ready)
{
    /// <summary>The statements of the profile's tool drive: the output with its settle time, or the subprograms that move the axis.</summary>
    /// <param name="ownPlunges">Strokes have plunge feeds of their own.</param>
    /// <param name="height">Formats a height of the controller.</param>
    public static (Func<CountsPoint, StrokeTerms?, IReadOnlyList<string>> On, IReadOnlyList<string> Off) ToolOf(MachineProfile profile, bool dryRun, bool ownPlunges, Func<int, string> height) => profile.Height is null
        ? ((_, terms) => dryRun ? [] : [Subprograms.ToolOn(profile), Settle(profile), Wait(terms?.PierceSeconds ?? 0.0)], [Subprograms.ToolOff(profile), Settle(profile, on: false)])
        : ((place, terms) => [$"z={height(place.Z)}", PlungeAssignment(profile, terms, ownPlunges), "JS" + Down, Wait(terms?.PierceSeconds ?? 0.0)], ["JS" + Up]);
}
