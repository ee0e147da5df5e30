using Engraver.Core.EntityTables;
using Engraver.Core.Sequencing;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Sequencing;

/// <summary>Findings about entities without a handle are whole sentences.</summary>
public class SequencingFindingsTests
{
    [Fact]
    public void An_entity_without_a_handle_is_described()
    {
        var drawing = new DrawingBuilder().Line(0, 0, 10, 0).Line(10.5, 0, 20, 0).Line(10.5, 0, 20, 0).Build();
        var table = EntityTableBuilder.Build(drawing, LayerSelection.Default);

        var sentences = Sequencer.Sequence(table, null, UsualOptions.Sequencing).Diagnostics.Select(finding => finding.Sentence).ToList();

        Assert.Contains("Segments that coincide with another one are cut once: 1, the first is an entity that has no handle.", sentences);
        Assert.Contains("The contour is open at 10, 0: the nearest other open end is 0.5 mm away, on an entity that has no handle.", sentences);
    }
}
