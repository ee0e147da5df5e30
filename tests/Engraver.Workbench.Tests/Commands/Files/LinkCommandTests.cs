using Engraver.Core.Geometry;
using Engraver.TestKit;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Tests.Commands.Files;

/// <summary>Worked example A of sace-xps-agie.md 4.4 as in the paper: each contour posted separately, then linked.</summary>
public class LinkCommandTests
{
    private const string Slot = "%\t001\t01\t000\t000\t+002000\t+000000\t02\n\t002\t01\t000\t000\t+020000\t+000000\t02\n\t003\t03\t270\t180\t+005000\t+005000\t02\n\t004\t01\t000\t000\t-020000\t+000000\t02\n\t005\t01\t000\t000\t+000000\t-010000\t02\t02\n";
    private const string Hole = "%\t001\t01\t000\t000\t+002000\t+000000\t02\n\t002\t02\t180\t180\t+003000\t+003000\t02\n\t003\t02\t000\t180\t+003000\t+003000\t02\t02\n";

    [Fact]
    public async Task Two_contours_become_one_program_with_a_positioning_block()
    {
        await using var talk = await TalkAsync();
        await talk.TypeAsync("LINK", "slot.agie", "-2,0", "hole.agie", "50,0", "", "both.agie");

        Assert.Equal(
            Slot.Replace("-010000\t02\t02\n", "-010000\t02\n", StringComparison.Ordinal) + "\t006\t01\t000\t000\t+050000\t+000000\t01\n"
                + Hole.Replace("%\t001", "\t007", StringComparison.Ordinal).Replace("\t002\t02", "\t008\t02", StringComparison.Ordinal).Replace("\t003\t02\t000", "\t009\t02\t000", StringComparison.Ordinal),
            await File.ReadAllTextAsync(talk.PathOf("both.agie")));
        Assert.Contains("2 contours linked, 9 blocks.", talk.Said, StringComparison.Ordinal);

        await talk.TypeAsync("LINK", "both.agie", "-2,0", "hole.agie", "90,0", "", "three.agie");
        Assert.Contains("3 contours linked, 13 blocks.", talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Where_a_posted_contour_begins_is_known_and_the_linked_program_is_verified()
    {
        await using var talk = new CommandTestSession();
        talk.Session.Document.Commit("OPEN", new DocumentState { Drawing = new DrawingBuilder().Line(3, 4, 20, 4).Build() });
        await talk.TypeAsync("AGIEPOST", "Exact", "a.agie");
        talk.Session.Document.Commit("OPEN", new DocumentState { Drawing = new DrawingBuilder().Circle(60, 0, 5.5).Build() });
        await talk.TypeAsync("AGIEPOST", "Exact", "b.agie");
        talk.Session.Document.Commit("OPEN", new DocumentState { Drawing = new DrawingBuilder().Line(3, 4, 20, 4).Circle(60, 0, 5.5).Build() });
        await talk.TypeAsync("LINK", "a.agie", "", "b.agie", "", "", "c.agie");

        Assert.IsNotType<InputResult.Failed>(await talk.TypeAsync("VERIFY", "c.agie"));
    }

    /// <summary>The format does not contain the start of a program: it is stored beside the file, and therefore independent of a later entry entity and of the
    /// session.</summary>
    [Fact]
    public async Task A_program_that_was_linked_with_an_entering_entity_is_verified_from_where_it_begins()
    {
        await using var talk = new CommandTestSession();
        var drawing = new DrawingBuilder().Line(3, 4, 20, 4).Circle(60, 0, 5.5).Build();
        talk.Session.Document.Commit("OPEN", new DocumentState { Drawing = drawing, Settings = new DrawingSettings { Enter = new ContourEntry.ByPoint(new Point2D(60, 5.5)) } });
        await talk.TypeAsync("AGIEPOST", "Exact", "a.agie", "LINK", "a.agie", "", "", "c.agie");
        await using var other = new CommandTestSession();
        File.Copy(talk.PathOf("c.agie"), other.PathOf("c.agie"));
        File.Copy(talk.PathOf("c.agie.start.json"), other.PathOf("c.agie.start.json"));
        other.Session.Document.Commit("OPEN", new DocumentState { Drawing = drawing });

        Assert.IsNotType<InputResult.Failed>(await other.TypeAsync("VERIFY", "c.agie"));
        await File.AppendAllTextAsync(other.PathOf("c.agie"), "\n");
        Assert.IsType<InputResult.Failed>(await other.TypeAsync("VERIFY", "c.agie"));
        Assert.Contains("belongs to another program", other.Said, StringComparison.Ordinal);
        await File.WriteAllTextAsync(other.PathOf("c.agie.start.json"), "{");
        Assert.IsType<InputResult.Failed>(await other.TypeAsync("VERIFY", "c.agie"));
        Assert.Contains("cannot be read", other.Said, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("%\t001\t01\t000\t000\t+002000\t+000000\t02\n")]
    [InlineData("%\t002\t01\t000\t000\t+002000\t+000000\t02\t02\n")]
    [InlineData("%\t001\t03\t000\t000\t+002000\t+002000\t02\t02\n")]
    [InlineData("%\t001\t03\t000\t090\t+002000\t+002001\t02\t02\n")]
    [InlineData("%\t001\t01\t000\t000\t+02000\t+000000\t02\t02\n")]
    [InlineData("hello\n")]
    [InlineData("")]
    public async Task A_file_that_is_no_program_is_named_and_nothing_is_written(string text)
    {
        await using var talk = await TalkAsync();
        await File.WriteAllTextAsync(talk.PathOf("bad.agie"), text);
        var result = await talk.TypeAsync("LINK", "slot.agie", "-2,0", "bad.agie", "50,0");

        Assert.Equal(CommandFailure.Drawing, Assert.IsType<InputResult.Failed>(result).Reason);
        Assert.Contains("bad.agie", talk.Said, StringComparison.Ordinal);
        Assert.Matches("PST0001|VER0001", talk.Said);
    }

    private static async Task<CommandTestSession> TalkAsync()
    {
        var talk = new CommandTestSession();
        await File.WriteAllTextAsync(talk.PathOf("slot.agie"), Slot);
        await File.WriteAllTextAsync(talk.PathOf("hole.agie"), Hole);
        return talk;
    }
}
