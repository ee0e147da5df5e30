using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;

namespace Engraver.App.Tests.CommandWindow;

[Collection(DesktopCollection.Name)]
public sealed class CompletionTests(DesktopFixture fixture)
{
    [Fact]
    public Task All_commands_that_match_are_listed_and_the_stop_is_the_first_of_CNC() => fixture.WithOperator(here =>
    {
        here.Hands.Type("cnc");
        var names = here.Window.Model.Command.Suggestions.Select(found => found.Command.Name).ToHashSet();

        Assert.Superset(here.Commands.Catalog.All.Select(info => info.Name).Where(name => name.StartsWith("CNC", StringComparison.Ordinal)).ToHashSet(), names);
        Assert.Equal("CNCSTOP", here.Window.Model.Command.Suggestions.First(found => found.Alias is null).Command.Name);
    });

    [Fact]
    public Task What_holds_the_letters_inside_comes_behind_what_begins_with_them() => fixture.WithOperator(here =>
    {
        here.Hands.Type("path");
        Assert.Contains("SACEPATH", here.Window.Model.Command.Suggestions.Select(found => found.Text));
        here.Hands.Press(Key.Escape);
        here.Hands.Type("order");

        Assert.Equal(["CNCORDER", "CNCORDERCOST", "CNCORDERTIME"], here.Window.Model.Command.Suggestions.Select(found => found.Text));
        here.Hands.Press(Key.Escape);
        here.Hands.Type("over");
        Assert.Equal(["OVERKILL", "CNCOVERRIDE", "CNCRECOVER"], here.Window.Model.Command.Suggestions.Where(found => found.Alias is null).Select(found => found.Text));
    });

    [Fact]
    public Task The_list_scrolls_to_the_one_that_is_chosen() => fixture.WithOperator(here =>
    {
        here.Hands.Type("cnc");
        here.Step();
        var last = here.Window.Model.Command.Suggestions.Count - 1;
        Assert.True(last > 20);
        for (var presses = 0; presses <= last; presses++) here.Hands.Press(Key.Down);
        here.Step();
        var list = here.Find<ListBox>("SuggestionList");
        var row = list.ContainerFromIndex(last)!;

        Assert.Equal(last, here.Window.Model.Command.Suggested);
        Assert.InRange(row.TranslatePoint(default, list)!.Value.Y, 0, list.Bounds.Height - row.Bounds.Height + 0.5);
        here.Hands.Press(Key.PageUp);
        Assert.InRange(here.Window.Model.Command.Suggested, 1, last - 5);
        Assert.True(list.Bounds.Height < 300);
    });
}
