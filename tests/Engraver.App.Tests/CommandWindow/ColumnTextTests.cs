using Avalonia.Controls;
using Avalonia.VisualTree;
using Engraver.App.CommandWindow;

namespace Engraver.App.Tests.CommandWindow;

[Collection(DesktopCollection.Name)]
public sealed class ColumnTextTests(DesktopFixture fixture)
{
    [Fact]
    public void Two_spaces_between_words_part_columns()
    {
        Assert.Equal([(2, "ZOOM"), (30, "Shows more or less.")], ColumnText.PartsOf("  ZOOM                        Shows more or less."));
        Assert.Equal([(0, "One sentence. And another.")], ColumnText.PartsOf("One sentence. And another."));
        Assert.Equal([(0, "")], ColumnText.PartsOf("   "));
    }

    /// <summary>The texts of one column start at the same position.</summary>
    [Theory]
    [InlineData("HELP")]
    [InlineData("CNCSTATUS")]
    public Task Columns_of_an_answer_stand_under_each_other(string command) => fixture.WithOperator(here =>
    {
        here.Enter("CNCCONNECT", "sim:", command, "");
        var rows = here.Find<ListBox>("HistoryList").GetVisualDescendants().OfType<ColumnText>().Where(row => row.Children.Count == 2 && row.Line!.Text.StartsWith("  ", StringComparison.Ordinal) == (command == "HELP")).ToList();

        Assert.True(rows.Count > 3, $"{rows.Count} rows are seen");
        Assert.Single(rows.GroupBy(row => ColumnText.PartsOf(row.Line!.Text)[1].Column).MaxBy(group => group.Count())!.Select(row => row.Children[1].Bounds.Left).Distinct());
        Assert.Empty(TextFit.CutOff(here.Find<ListBox>("HistoryList")));
    });
}
