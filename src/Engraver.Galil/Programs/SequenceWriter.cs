using Engraver.Galil.Profiles;
using static Engraver.Galil.Programs.Subprograms;

namespace Engraver.Galil.Programs;

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
        for (var i = 0; i < stroke.Sequences.Count; i++) Sequence(lines, stroke.Sequences[i], i == 0 ? spelling.ToolOn : []);
        return lines.Line(ToolOff(profile), Settle(profile)).Lines;
    }

    private void Sequence(ProgramLines lines, VectorSequence sequence, IReadOnlyList<string> toolOn)
    {
        lines.Line(spelling.Open, "VMAB", Text($"VS {sequence.Speed}"));
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
    private static IEnumerable<List<string>> Groups(VectorSequence sequence)
    {
        var group = new List<string>();
        var length = -1;
        foreach (var segment in sequence.Segments)
        {
            var command = DmcFormat.Command(segment, sequence.Start);
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
