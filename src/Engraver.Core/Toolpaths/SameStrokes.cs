using System.Collections;
using Engraver.Core.Sequencing;

namespace Engraver.Core.Toolpaths;

/// <summary>Sequenced strokes that are cut as they are, each made when it is asked for.</summary>
internal sealed class SameStrokes(IReadOnlyList<SequencedStroke> strokes) : IReadOnlyList<ToolpathStroke>
{
    public int Count => strokes.Count;

    public ToolpathStroke this[int index] => Same(strokes[index]);

    public IEnumerator<ToolpathStroke> GetEnumerator()
    {
        foreach (var stroke in strokes) yield return Same(stroke);
    }

    IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();

    private static ToolpathStroke Same(SequencedStroke stroke) => new(stroke.Index, stroke.Closed, stroke.Moves);
}
