using System.Collections.Immutable;
using Engraver.Core.TextMarkup;
using Engraver.Workbench.SerialTexts;
using FsCheck.Xunit;

namespace Engraver.Workbench.Tests.SerialTexts;

public class PlateValuesTests
{
    private static readonly PlateValues s_plate = new()
    {
        Counters = ImmutableSortedDictionary<string, long>.Empty.WithComparers(StringComparer.OrdinalIgnoreCase).Add("n", 42).Add("lot", 7),
        Date = new DateTimeOffset(2027, 1, 1, 8, 5, 9, TimeSpan.FromHours(1)),
        Row = new CsvRow(3, [new CsvValue("NAME", "Miller, John"), new CsvValue("TITLE", "")]),
        Copy = 2,
    };

    [Theory]
    [InlineData("SERIAL [[n:0000]]", "SERIAL 0042")]
    [InlineData("[[n]]/[[N:00]]", "42/42")]
    [InlineData("[[n LOT:000;start=5;step=2]]", "007")]
    [InlineData("[[n:0000;start=17]] of [[copy:00]]", "0042 of 02")]
    [InlineData("[[date]] [[date:dd.MM.yy HH:mm:ss]]", "2027-01-01 01.01.27 08:05:09")]
    [InlineData("[[date:GGww]] [[date:yyDDD]]", "2653 27001")]
    [InlineData("Dear [[csv:name]]", "Dear Miller, John")]
    [InlineData("[[csv:TITLE?]][[csv:NAME]]", "Miller, John")]
    [InlineData("[[csv:N\\U+0041ME]]", "Miller, John")]
    [InlineData("no field", "no field")]
    [InlineData("a [[b+c]] [[n]]", "a [[b+c]] 42")]
    [InlineData("[[ [[n]]", "[[ 42")]
    public void Fields_are_replaced_by_the_values(string raw, string filled) => Assert.Equal(filled, s_plate.Fill(raw, ""));

    [Fact]
    public void Without_values_a_string_remains_as_it_is() => Assert.Equal("[[n:0000]] [[", PlateValues.None.Fill("[[n:0000]] [[", "NAME"));

    [Fact]
    public void The_tag_of_an_attribute_selects_a_column_unless_its_string_has_a_field()
    {
        Assert.Equal("Miller, John", s_plate.Fill("your name", "Name"));
        Assert.Equal("42", s_plate.Fill("[[n]]", "NAME"));
        Assert.Equal("your name", s_plate.Fill("your name", "ADDRESS"));
    }

    [Theory]
    [InlineData("[[csv:ADDRESS]]", "", "ADDRESS")]
    [InlineData("[[csv:TITLE]]", "", "TITLE")]
    [InlineData("text", "TITLE", "TITLE")]
    [InlineData("[[n SERIES]]", "", "SERIES")]
    [InlineData("[[n LOT:00]] [[n:0]]", "", null)]
    [InlineData("[[number:000]]", "", "number:000")]
    [InlineData("[[n:00x]]", "", "00x")]
    [InlineData("[[n:00;step=0]]", "", "step=0")]
    [InlineData("[[n:00;from=1]]", "", "from=1")]
    [InlineData("[[n 1:00]]", "", "1")]
    [InlineData("[[date:YYYY]]", "", "YYYY")]
    [InlineData("[[csv]]", "", "column")]
    [InlineData("[[copy twice]]", "", "twice")]
    public void A_field_without_a_value_is_reported_with_its_reason(string raw, string tag, string? reason)
    {
        var problems = s_plate.ProblemsIn(raw, tag);
        if (reason is null) Assert.Empty(problems);
        else Assert.Contains(reason, Assert.Single(problems).Reason, StringComparison.Ordinal);
    }

    [Fact]
    public void A_number_that_does_not_fit_its_place_is_not_engraved()
    {
        var plate = s_plate with { Counters = s_plate.Counters.SetItem("n", 10_000) };
        Assert.Equal("10000", plate.Fill("[[n]]", ""));
        Assert.Contains("10000", Assert.Single(plate.ProblemsIn("[[n:0000]]", "")).Reason, StringComparison.Ordinal);
        Assert.Equal("[[n:0000]]", plate.Fill("[[n:0000]]", ""));
    }

    [Theory]
    [InlineData("100%%d {\\Pnew} \\H5; ^J \\U+0041 %<\\AcVar>%")]
    [InlineData("%%")]
    [InlineData("\\")]
    [InlineData("[[n]]")]
    [InlineData("5")]
    [InlineData("x;")]
    public void A_value_is_never_read_as_codes(string value)
    {
        foreach (var before in (string[])["", "%", "%%", "^", "\\", "\\H2", "\\C1", "\\U+00", "{\\fArial;", "%%u"])
        {
            var text = Plain(TextCodes.Parse(Row(value).Fill(before + "[[csv:V]]%%u", "")));
            Assert.EndsWith(value, text, StringComparison.Ordinal);
            Assert.Equal(Plain(TextCodes.Parse(before)), text[..^value.Length]);
            Assert.EndsWith(value, Plain(MTextParser.Parse(Row(value).Fill(before + "[[csv:V]]", ""))), StringComparison.Ordinal);
        }
    }

    [Property]
    public bool Any_value_is_the_same_characters_in_a_text_and_a_paragraph_text(string? written)
    {
        var value = new string([.. (written ?? "").Where(letter => letter >= ' ')]);
        if (value.Length == 0) return true;
        return Plain(TextCodes.Parse(Row(value).Fill("[[csv:V]]", ""))) == value.ReplaceLineEndings(" ") && Plain(MTextParser.Parse(Row(value).Fill("{[[csv:V]]}", ""))) == value.ReplaceLineEndings("\n");
    }

    [Fact]
    public void A_value_inside_a_stack_does_not_divide_it()
    {
        var stack = MTextParser.Parse(Row("1/2;^#").Fill("\\S[[csv:V]]/4;", "")).Paragraphs[0].Pieces[0].Stack!;
        Assert.Equal(("1/2;^#", "4"), (stack.Upper, stack.Lower));
    }

    [Fact]
    public void A_line_feed_of_a_value_ends_a_paragraph_and_is_a_blank_in_a_text()
    {
        Assert.Equal("a b", Plain(TextCodes.Parse(Row("a\r\nb").Fill("[[csv:V]]", ""))));
        Assert.Equal(2, MTextParser.Parse(Row("a\r\nb").Fill("[[csv:V]]", "")).Paragraphs.Count);
    }

    [Fact]
    public void Values_are_compared_by_value_and_survive_their_record()
    {
        var read = PlateValues.FromJson(s_plate.ToJson());
        Assert.Equal(s_plate, read);
        Assert.Equal(s_plate.GetHashCode(), read.GetHashCode());
        Assert.NotEqual(s_plate, read with { Row = read.Row! with { Number = 4 } });
        Assert.NotEqual(s_plate, read with { Counters = read.Counters.SetItem("n", 43) });
        Assert.Equal(PlateValues.None, PlateValues.FromJson(PlateValues.None.ToJson()));
        Assert.True(PlateValues.FromJson("{}").IsNone);
    }

    [Theory]
    [InlineData("")]
    [InlineData("null")]
    [InlineData("[]")]
    [InlineData("""{"row":{"number":1}}""")]
    [InlineData("""{"counters":{"n":1,"N":2}}""")]
    public void A_record_that_is_not_one_is_refused(string text) => Assert.Throws<FormatException>(() => PlateValues.FromJson(text));

    [Fact]
    public void The_line_of_a_plate_is_stable()
    {
        Assert.Equal("lot=7, n=42, date=2027-01-01T08:05:09+01:00, copy=2, csv row 3: NAME=\"Miller, John\", TITLE=", s_plate.ToString());
        Assert.Equal("", PlateValues.None.ToString());
        Assert.Equal("csv row 1: V=\"a\\nb\"", Row("a\nb").ToString());
    }

    private static PlateValues Row(string value) => new() { Row = new CsvRow(1, [new CsvValue("V", value)]) };

    private static string Plain(TextLine line) => string.Concat(line.Runs.Select(run => run.Text));

    private static string Plain(MTextContent content) => string.Join('\n', content.Paragraphs.Select(paragraph => string.Concat(paragraph.Pieces.Select(piece => piece.Text))));
}
