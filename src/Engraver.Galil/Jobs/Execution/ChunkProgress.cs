using Engraver.Core.Machines;
using Engraver.Galil.Programs.Posting;

namespace Engraver.Galil.Jobs.Execution;

/// <summary>Converts the counters of a running chunk to the job's terms: seq and _CSS to segments, a line of the program to an entity.</summary>
/// <param name="chunk">The program in the controller.</param>
/// <param name="before">Segments that earlier chunks have cut.</param>
internal sealed class ChunkProgress(ProgramChunk chunk, int before)
{
    private readonly VectorSegment[] _segments = [.. chunk.Segments];
    private readonly int[] _sequenceStarts = Starts(chunk);
    private readonly int _endMark = SupervisedProgram.EndMark(chunk);

    public bool IsEnd(int mark) => mark == _endMark;

    /// <summary>Whether the tool should be on in the chunk: on while a sequence runs, off in a rapid (the motion between two sequences); null where that
    /// depends on the line it executes.</summary>
    public static bool? IsToolWanted(JobPoll state) => (state.Calls % 2 != 0, state.SequenceRunning, state.AxesRunning) switch
    {
        (true, true, _) => true,
        (false, false, true) => false,
        _ => null,
    };

    /// <summary>Segments of the job that are done.</summary>
    /// <param name="mark">seq: two for each completed sequence, one more while one is being cut.</param>
    /// <param name="counter">_CSS; belongs to a sequence only while one is being cut.</param>
    public int Executed(int mark, int counter)
    {
        return before + Within(_sequenceStarts, mark, counter);
    }

    /// <summary>The same within the chunk.</summary>
    /// <param name="starts">Segments before each of its sequences, and as the last number all of them.</param>
    public static int Within(IReadOnlyList<int> starts, int mark, int counter)
    {
        var sequence = Math.Clamp(mark / 2, 0, starts.Count - 1);
        return starts[sequence] + (mark % 2 != 0 && sequence + 1 < starts.Count ? Math.Clamp(counter, 0, starts[sequence + 1] - starts[sequence]) : 0);
    }

    /// <summary>Segments before each sequence of the chunk, and as the last number all of them.</summary>
    public IReadOnlyList<int> SequenceStarts => _sequenceStarts;

    /// <summary>The entity of the present sequence, as a sentence of its own.</summary>
    public string PlaceAt(int mark) => Entity(_sequenceStarts[Math.Clamp(mark / 2, 0, _sequenceStarts.Length - 1)]);

    /// <summary>How the tool is brought to the work and taken away at the present stroke; null: as the profile states.</summary>
    public StrokeTerms? TermsAt(int mark)
    {
        var sequence = mark / 2;
        foreach (var part in chunk.Parts)
        {
            if (sequence < part.Sequences.Count) return part.Terms;
            sequence -= part.Sequences.Count;
        }

        return null;
    }

    /// <summary>The text of a program line and the entity it cuts, or the next one that is cut after it.</summary>
    /// <param name="line">Line of the program, from 0.</param>
    public string PlaceOf(int line)
    {
        var lines = chunk.Text.Split('\n');
        if (line < 0 || line >= lines.Length) return "";
        var first = lines.Take(line).Sum(Segments);
        return Wording.Get("ChunkProgress.ProgramLine", lines[line]) + Entity(first);
    }

    private string Entity(int segment) => segment < _segments.Length ? Wording.Get("Execution.DrawingEntity", _segments[segment].EntityIndex) : "";

    private static int Segments(string line) => line.Split(';').Count(statement => statement.StartsWith("VP ", StringComparison.Ordinal) || statement.StartsWith("CR ", StringComparison.Ordinal) || statement.StartsWith("LI ", StringComparison.Ordinal));

    private static int[] Starts(ProgramChunk chunk)
    {
        var starts = new List<int> { 0 };
        foreach (var sequence in chunk.Parts.SelectMany(part => part.Sequences)) starts.Add(starts[^1] + sequence.Segments.Count);
        return [.. starts];
    }
}
