using Engraver.Core.Drawings;
using Engraver.Workbench.Lettering;
using static Engraver.Workbench.Tests.Lettering.Paragraphs.LaidParagraphs;

namespace Engraver.Workbench.Tests.Lettering.Paragraphs;

public class ColumnTests
{
    private const string Six = @"A\PB\PC\PD\PE\PF";

    /// <summary>Room for two lines: the second baseline is at 80/3.</summary>
    private static readonly WrittenParagraphs s_static = new() { DefinedHeight = 30.0, Columns = new TextColumns { Type = 1, Count = 3, Width = 50.0, Gutter = 5.0 } };

    [Fact]
    public void Lines_flow_from_column_to_column_and_the_last_takes_the_rest()
    {
        Assert.Equal([(0.0, 0), (0.0, 1), (55.0, 0), (55.0, 1), (110.0, 0), (110.0, 1)], Places(Six, s_static));
        Assert.Equal([(0.0, 0), (0.0, 1), (55.0, 0), (55.0, 1), (55.0, 2), (55.0, 3)], Places(Six, s_static with { Columns = s_static.Columns! with { Count = 2 } }));
    }

    [Fact]
    public void A_paragraph_wraps_at_the_width_of_the_column()
    {
        Assert.Equal("HOHOHO|HO", Letters(Of("HOHOHO HO", s_static)));
        Assert.Equal("HOHOHOHO", Letters(Of("HOHOHO HO", new() { ReferenceWidth = 200.0 })));
    }

    [Fact]
    public void A_reversed_flow_begins_at_the_right() =>
        Assert.Equal([(110.0, 0), (110.0, 1), (55.0, 0), (55.0, 1), (0.0, 0), (0.0, 1)], Places(Six, s_static with { Columns = s_static.Columns! with { IsFlowReversed = true } }));

    [Fact]
    public void Dynamic_columns_are_as_many_as_the_text_fills()
    {
        var columns = new TextColumns { Type = 2, IsAutoHeight = true, Width = 50.0, Gutter = 5.0 };
        Assert.Equal([(0.0, 0), (55.0, 0), (110.0, 0), (165.0, 0), (220.0, 0), (275.0, 0)], Places(Six, new() { DefinedHeight = 12.0, Columns = columns }));
        Assert.Equal([(0.0, 0), (0.0, 1), (0.0, 2), (0.0, 3), (0.0, 4), (0.0, 5)], Places(Six, new() { Columns = columns }));
    }

    [Fact]
    public void Columns_of_stated_heights_differ()
    {
        var columns = new TextColumns { Type = 2, Count = 3, Width = 50.0, Gutter = 5.0, Heights = [12.0, 50.0, 0.0] };
        Assert.Equal([(0.0, 0), (55.0, 0), (55.0, 1), (55.0, 2), (110.0, 0), (110.0, 1)], Places(Six, new() { Columns = columns }));
    }

    [Fact]
    public void A_column_break_begins_the_next_column_and_ends_the_line_of_a_text_without_columns()
    {
        Assert.Equal([(0.0, 0), (55.0, 0)], Places(@"A\NB", s_static));
        Assert.Equal([(0.0, 0), (0.0, 1)], Places(@"A\NB", new()));
        Assert.Equal(Box(Of("A", new() { Attachment = 7 })), Box(Of(@"A\N", new() { Attachment = 7 })));
    }

    [Fact]
    public void The_box_of_all_columns_is_attached()
    {
        Assert.Equal(-110.0 - Inked("A"), Of("A", s_static with { Attachment = 3 }).Glyphs[0].Map.Origin.X, 9);
        Assert.Equal(30.0 - 10.0, Of("A", s_static with { Attachment = 7 }).Glyphs[0].Map.Origin.Y, 9);
        Assert.Equal(-80.0, Of(@"\pql;A", s_static with { Attachment = 2 }).Glyphs[0].Map.Origin.X, 9);
    }

    [Fact]
    public void The_text_of_linked_columns_is_the_first_column()
    {
        var layout = Of(@"A\PB\N", new() { DefinedHeight = 12.0, ReferenceWidth = 500.0, Columns = new TextColumns { Type = 1, Count = 3, Width = 50.0, Gutter = 5.0, LinkedHandles = [0x1B4, 0x1B5] } });
        Assert.Equal([0.0, 0.0], layout.Glyphs.Select(glyph => glyph.Map.Origin.X));
        Assert.Equal(LayoutNoteKind.FormIgnored, Assert.Single(layout.Notes).Kind);
    }

    /// <summary>Of each letter: left side of its column, and its line in the column.</summary>
    private static (double X, int Line)[] Places(string raw, WrittenParagraphs written) =>
        [.. Of(raw, written).Glyphs.Select(glyph => (Math.Round(glyph.Map.Origin.X, 9), (int)Math.Round((-glyph.Map.Origin.Y - Height) / (Height * 5.0 / 3.0))))];
}
