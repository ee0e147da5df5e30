using Engraver.Core.EntityTables;
using Engraver.TestKit;

namespace Engraver.Core.Tests.EntityTables;

public class TableWeightTests
{
    private const int Rows = 20_480;

    [Fact]
    public void A_flat_line_takes_a_third_of_its_sixteen_slots()
    {
        var lines = Enumerable.Range(0, Rows).Aggregate(new DrawingBuilder(), (sheet, i) => sheet.Line(i, 0, i + 0.5, 1)).Build();
        _ = EntityTableBuilder.Build(lines, LayerSelection.Default);
        var before = GC.GetAllocatedBytesForCurrentThread();
        var table = EntityTableBuilder.Build(lines, LayerSelection.Default);
        var bytes = (double)(GC.GetAllocatedBytesForCurrentThread() - before) / Rows;

        Assert.Equal(Rows, table.Count);
        Assert.InRange(bytes, 8.0, 40.0);
        Assert.Same(table, ArcAnalysis.Analyse(table));
    }

    [Fact]
    public void A_slot_that_changes_within_a_chunk_is_kept_for_each_row_and_zero_keeps_its_sign()
    {
        var sheet = new DrawingBuilder();
        for (var i = 0; i < 5_000; i++) _ = i % 1_000 == 999 ? sheet.Circle(i, -0.0, i + 1) : sheet.Line(i, 0, i + 1, -0.0);
        var table = ArcAnalysis.Analyse(EntityTableBuilder.Build(sheet.Build(), LayerSelection.Default));

        for (var i = 0; i < table.Count; i++)
        {
            var row = table[i];
            Assert.Equal(i % 1_000 == 999 ? (2.0, i + 1.0, 360.0) : (1.0, 0.0, 0.0), (row[EntitySlot.Kind], row[EntitySlot.Radius], row[EntitySlot.Sweep]));
            if (i % 1_000 != 999) Assert.True(double.IsNegative(row[EntitySlot.EndY]) && !double.IsNegative(row[EntitySlot.StartY]) && row[EntitySlot.EndX] == i + 1.0);
        }
    }
}
