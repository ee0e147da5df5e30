using System.Text;
using Engraver.Workbench.SerialTexts;

namespace Engraver.Workbench.Tests.SerialTexts;

public class CsvTableTests
{
    [Theory]
    [InlineData("NAME,CITY\nMiller,Rome\n")]
    [InlineData("NAME;CITY\r\nMiller;Rome\r\n")]
    [InlineData("NAME\tCITY\rMiller\tRome")]
    [InlineData("\n\n\"NAME\", CITY \n\"Miller\",Rome\n\n\n")]
    [InlineData("sep=;\nNAME;CITY\nMiller;Rome\n")]
    [InlineData("NAME;\"CITY\"\nMiller;Rome\n;\n")]
    public void The_separator_is_found_from_the_header(string text)
    {
        var (table, findings) = CsvTable.Read(Encoding.UTF8.GetBytes(text));
        Assert.Empty(findings);
        Assert.Equal(["NAME", "CITY"], table!.Columns);
        var row = Assert.Single(table.Rows);
        Assert.Equal((1, "Miller", "Rome"), (row.Number, row.Find("name"), row.Find("CITY")));
        Assert.Null(row.Find("STREET"));
    }

    [Fact]
    public void Quoted_values_hold_separators_quotes_and_lines()
    {
        var (table, findings) = CsvTable.Read("A,B\n\"1,\"\"2\"\"\r\n3\",4\n5,6\n"u8.ToArray());
        Assert.Empty(findings);
        Assert.Equal("1,\"2\"\r\n3", table!.Rows[0].Find("A"));
        Assert.Equal("6", table.Rows[1].Find("B"));
    }

    [Fact]
    public void A_header_that_quotes_a_separator_does_not_count_it()
    {
        var (table, _) = CsvTable.Read("\"a;b;c\",B\n1,2\n"u8.ToArray());
        Assert.Equal(["a;b;c", "B"], table!.Columns);
    }

    public static TheoryData<byte[], bool> Encodings => new()
    {
        { Encoding.UTF8.GetBytes("N\nGrün\n"), false },
        { [.. Encoding.UTF8.Preamble, .. Encoding.UTF8.GetBytes("N\nGrün\n")], false },
        { [.. Encoding.Unicode.Preamble, .. Encoding.Unicode.GetBytes("N\nGrün\n")], false },
        { [.. Encoding.BigEndianUnicode.Preamble, .. Encoding.BigEndianUnicode.GetBytes("N\nGrün\n")], false },
        { [.. "N\nGr"u8, 0xFC, .. "n\n"u8], true },
    };

    [Theory]
    [MemberData(nameof(Encodings))]
    public void The_characters_are_those_of_the_file(byte[] bytes, bool isWestern)
    {
        var (table, findings) = CsvTable.Read(bytes);
        Assert.Equal("Grün", table!.Rows[0].Find("N"));
        Assert.Equal(isWestern ? ["SER0011"] : [], findings.Select(finding => finding.Id));
    }

    [Theory]
    [InlineData("", "SER0017(0)")]
    [InlineData("\n \n", "SER0017(0)")]
    [InlineData("A,B\n", "SER0017(1)")]
    [InlineData("A,B,a\n1,2,3\n", "SER0012(1)")]
    [InlineData("A,,C\n1,2,3\n", "SER0013(1)")]
    [InlineData("A,B\n1\n2,3\n", "SER0014(2)")]
    [InlineData("A,B\n1,2\n\"x\ny\",2\n1,2,3\n", "SER0014(5)")]
    [InlineData("A,B\n1,2\n\n\n3,4\n", "SER0015(3)")]
    [InlineData("A,B\n1,\"2\n3,4\n", "SER0016(2)")]
    [InlineData("A,B\n\"1\"x,2\n", "SER0016(2)")]
    [InlineData("A\nMiller, John\n", "SER0014(2) SER0017(1)")]
    [InlineData("A\0B\n1\n", "SER0010(0)")]
    public void What_is_wrong_is_reported_with_its_line(string text, string expected)
    {
        var (table, findings) = CsvTable.Read(Encoding.UTF8.GetBytes(text));
        Assert.Equal(expected, string.Join(' ', findings.Select(finding => $"{finding.Id}({finding.Source.Line})")));
        Assert.Equal(expected.StartsWith("SER0015", StringComparison.Ordinal), table is not null);
    }

    [Fact]
    public void A_missing_file_is_a_finding() => Assert.Equal("SER0010", Assert.Single(CsvTable.Read(Path.Combine(Path.GetTempPath(), "no-such-file.csv")).Findings).Id);

    [Fact]
    public void Any_bytes_end_with_a_table_or_an_error()
    {
        var random = new Random(8);
        for (var i = 0; i < 2000; i++)
        {
            var bytes = new byte[random.Next(60)];
            for (var at = 0; at < bytes.Length; at++) bytes[at] = random.Next(3) == 0 ? (byte)random.Next(256) : (byte)",;\t\"\r\nab"[random.Next(8)];
            var (table, findings) = CsvTable.Read(bytes);
            Assert.Equal(table is null, findings.Any(finding => finding.Severity == Core.Diagnostics.Severity.Error));
        }
    }
}
