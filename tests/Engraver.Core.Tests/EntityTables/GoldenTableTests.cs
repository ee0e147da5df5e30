using Engraver.Core.EntityTables;
using Engraver.Core.Sequencing;
using Engraver.TestKit;

namespace Engraver.Core.Tests.EntityTables;

/// <summary>Paper 001, Table 3 (paper-001-readings.md, golden tables a and b).</summary>
public class GoldenTableTests
{
    private const string Header = "s0,s1,s2,s3,s4,s5,s6,s7,s8,s9,s10,s11,s12,s13,s14,s15\n";

    [Fact]
    public void The_table_as_built_holds_the_28_printed_cells_and_zero_elsewhere()
    {
        var table = EntityTableBuilder.Build(SampleDrawings.PaperSample(), LayerSelection.Default);

        Assert.Equal(
            Header
            + "1,50,50,0,150,50,0,0,0,0,0,0,0,0,0,0\n"
            + "1,150,50,0,150,150,0,0,0,0,0,0,0,0,0,0\n"
            + "3,0,0,0,0,0,0,100,150,0,50,0,180,0,0,0\n"
            + "1,50,150,0,50,50,0,0,0,0,0,0,0,0,0,0\n",
            Csv(table));
    }

    [Fact]
    public void The_analysed_and_sequenced_table_is_golden_table_b()
    {
        var analysed = ArcAnalysis.Analyse(EntityTableBuilder.Build(SampleDrawings.PaperSample(), LayerSelection.Default));

        var sequenced = Sequencer.Sequence(analysed, null, UsualOptions.Sequencing);

        Assert.Equal(
            Header
            + "1,50,50,0,150,50,0,0,0,0,0,0,0,1,0,0\n"
            + "1,150,50,0,150,150,0,0,0,0,0,0,0,2,0,0\n"
            + "3,150,150,0,50,150,0,100,150,0,50,0,180,3,0,180\n"
            + "1,50,150,0,50,50,0,0,0,0,0,0,0,4,0,0\n",
            Csv(sequenced.Table));
    }

    private static string Csv(EntityTable table)
    {
        using var text = new StringWriter();
        EntityTableCsv.Write(table, text);
        return text.ToString();
    }
}
