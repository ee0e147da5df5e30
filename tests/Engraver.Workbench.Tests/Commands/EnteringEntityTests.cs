using Engraver.TestKit;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Tests.Commands;

/// <summary>The entry entity after edits that replace it.</summary>
public class EnteringEntityTests
{
    [Fact]
    public async Task Joined_into_a_polyline_it_is_that_polyline()
    {
        await using var talk = Talk(new DrawingBuilder().Line(0, 50, 5, 50).Line(6, 50, 6, 60).Line(0, 0, 10, 0).Line(10, 0, 10, 10));
        await talk.TypeAsync("ENTER", "Handle", "A4", "JOIN", "ALL", "");

        Assert.Equal(talk.State.Drawing!.Entities.Count - 1, talk.State.Drawing.IndexOfHandle(Entered(talk)!));
        Assert.Contains($"The entering entity A4 was replaced by {Entered(talk)}. Cutting begins there.", talk.Said, StringComparison.Ordinal);
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("AUTOSEQUENCE", ""));
    }

    [Fact]
    public async Task Erased_as_a_double_it_is_the_one_that_stays()
    {
        await using var talk = Talk(new DrawingBuilder().Line(0, 0, 10, 0).Line(5, -5, 5, 5).Line(10, 0, 0, 0));
        await talk.TypeAsync("ENTER", "Handle", "A3", "OVERKILL", "ALL", "", "");

        Assert.Equal("A1", Entered(talk));
        Assert.Contains("The entering entity A3 was replaced by A1", talk.Said, StringComparison.Ordinal);
        Assert.EndsWith("\n1 duplicate erased.", talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Taken_apart_it_is_its_first_part()
    {
        await using var talk = Talk(new DrawingBuilder().Circle(40, 40, 3).Square(0, 0, 10));
        await talk.TypeAsync("ENTER", "Handle", "A2", "EXPLODE", "ALL", "");

        Assert.Equal(1, talk.State.Drawing!.IndexOfHandle(Entered(talk)!));
    }

    [Fact]
    public async Task Erased_it_is_said_to_be_gone_by_name()
    {
        await using var talk = Talk(new DrawingBuilder().Line(0, 0, 10, 0).Line(10, 0, 0, 0));
        await talk.TypeAsync("ENTER", "Handle", "A2", "ERASE", "H", "A2", "");

        Assert.Null(talk.State.Settings.Enter);
        Assert.Contains("The entering entity A2 was removed. The first stroke is chosen automatically.", talk.Said, StringComparison.Ordinal);
    }

    private static CommandTestSession Talk(DrawingBuilder drawing)
    {
        var talk = new CommandTestSession();
        talk.Session.Document.Commit("OPEN", new DocumentState { Drawing = drawing.Build() });
        return talk;
    }

    private static string? Entered(CommandTestSession talk) => (talk.State.Settings.Enter as ContourEntry.ByHandle)?.Handle;
}
