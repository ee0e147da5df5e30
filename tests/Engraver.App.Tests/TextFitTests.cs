using Avalonia.Controls;
using Avalonia.Media;

namespace Engraver.App.Tests;

/// <summary>Tests the check of texts itself: it must find each way in which a text is cut off, and nothing else.</summary>
[Collection(DesktopCollection.Name)]
public sealed class TextFitTests(DesktopFixture fixture)
{
    private const string Words = "Nothing is selected.";

    [Theory]
    [InlineData("whole", false)]
    [InlineData("narrow", true)]
    [InlineData("low", true)]
    [InlineData("wrapped", false)]
    [InlineData("wrapped too low", true)]
    [InlineData("dots", true)]
    [InlineData("dots with a tip", false)]
    [InlineData("beyond a clip", true)]
    [InlineData("scrolled away", false)]
    [InlineData("beside a scroll", true)]
    [InlineData("hidden", false)]
    public Task A_text_that_is_not_shown_whole_is_found(string way, bool found) => fixture.WithOperator(here =>
    {
        var place = here.Find<Border>("CanvasPlace");
        place.Child = Of(way);
        here.Step();

        Assert.Equal(found ? 1 : 0, TextFit.CutOff(place).Count);
    });

    [Theory]
    [InlineData(0, 0, true)]
    [InlineData(0, 30, false)]
    [InlineData(60, 4, true)]
    [InlineData(200, 0, false)]
    public Task Texts_over_each_other_are_found(double left, double top, bool found) => fixture.WithOperator(here =>
    {
        var place = here.Find<Border>("CanvasPlace");
        var other = new TextBlock { Text = "Another one.", [Avalonia.Controls.Canvas.LeftProperty] = left, [Avalonia.Controls.Canvas.TopProperty] = top };
        place.Child = new Avalonia.Controls.Canvas { Children = { new TextBlock { Text = Words }, other } };
        here.Step();

        Assert.Equal(found ? 1 : 0, TextFit.Overlapping(place).Count);
    });

    private static Control Of(string way) => way switch
    {
        "narrow" => new TextBlock { Text = Words, Width = 60 },
        "low" => new TextBlock { Text = Words, Height = 6 },
        "wrapped" => new TextBlock { Text = Words, Width = 70, TextWrapping = TextWrapping.Wrap },
        "wrapped too low" => new TextBlock { Text = Words, Width = 70, TextWrapping = TextWrapping.Wrap, MaxLines = 1 },
        "dots" => new TextBlock { Text = Words, Width = 60, TextTrimming = TextTrimming.CharacterEllipsis },
        "dots with a tip" => new TextBlock { Text = Words, Width = 60, TextTrimming = TextTrimming.CharacterEllipsis, [ToolTip.TipProperty] = Words },
        "beyond a clip" => new Border { Width = 40, Height = 60, ClipToBounds = true, Child = new StackPanel { Orientation = Avalonia.Layout.Orientation.Horizontal, Children = { new TextBlock { Text = Words } } } },
        "scrolled away" => new ScrollViewer { Width = 300, Height = 60, Content = new StackPanel { Children = { new Border { Height = 400 }, new TextBlock { Text = Words } } } },
        "beside a scroll" => new ScrollViewer { Width = 60, Height = 60, Content = new StackPanel { Orientation = Avalonia.Layout.Orientation.Horizontal, Children = { new Border { Width = 40 }, new TextBlock { Text = Words } } } },
        "hidden" => new TextBlock { Text = Words, Width = 60, IsVisible = false },
        _ => new TextBlock { Text = Words, HorizontalAlignment = Avalonia.Layout.HorizontalAlignment.Left },
    };
}
