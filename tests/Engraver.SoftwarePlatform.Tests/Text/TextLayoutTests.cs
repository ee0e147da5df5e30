using Avalonia;
using Avalonia.Media;
using Avalonia.Media.TextFormatting;
using Engraver.SoftwarePlatform.Tests.Headless;

namespace Engraver.SoftwarePlatform.Tests.Text;

/// <summary>Caret positions and hit tests of Avalonia's layout on the clusters of this shaper.</summary>
[Collection(DesktopCollection.Name)]
public sealed class TextLayoutTests(DesktopFixture fixture)
{
    private const double Size = 20;

    [Fact]
    public Task A_caret_moves_to_the_left_in_Hebrew() => WithLayout("ab \u05D0\u05D1\u05D2 cd", layout =>
    {
        var places = Enumerable.Range(0, 9).Select(index => layout.HitTestTextPosition(index).X).ToList();

        Assert.True(places[0] < places[1] && places[1] < places[2]);
        Assert.True(places[4] > places[5], string.Join(' ', places));
        Assert.True(places[7] > places[4] && places[7] < places[8]);
    });

    [FontFact(InstalledFont.Devanagari)]
    public Task A_caret_does_not_stop_inside_a_syllable() => WithLayout("\u0915\u093F\u0915\u094D\u0937", layout =>
    {
        double start = layout.HitTestTextPosition(0).X, middle = layout.HitTestTextPosition(2).X, end = layout.HitTestTextPosition(5).X;

        Assert.Equal(0, start);
        Assert.True(start < middle && middle < end);
        Assert.Contains(layout.HitTestTextPosition(1).X, new[] { start, middle });
        Assert.Equal(layout.WidthIncludingTrailingWhitespace, end, 6);
    });

    [FontFact(InstalledFont.Arabic)]
    public Task The_point_of_a_caret_is_its_character_in_each_direction()
    {
        return WithLayout("file \u0645\u0644\u0641 12.dxf \u05E7\u05D5\u05D1\u05E5", layout =>
        {
            for (var index = 0; index < 20; index++)
            {
                var area = layout.HitTestTextRange(index, 1).Single();
                var hit = layout.HitTestPoint(area.Center);
                Assert.True(hit.IsInside);
                Assert.InRange(hit.CharacterHit.FirstCharacterIndex, index, index);
            }
        });
    }

    [FontFact(InstalledFont.Arabic)]
    public Task A_ligature_is_hit_as_a_whole() => WithLayout("\u0644\u0627", layout =>
    {
        var hit = layout.HitTestPoint(new Point(layout.Width * 0.4, layout.Height / 2)).CharacterHit;

        Assert.Equal((0, 2), (hit.FirstCharacterIndex, hit.TrailingLength));
    }, FlowDirection.RightToLeft);

    [Fact]
    public Task A_selection_over_a_change_of_direction_has_two_areas() => WithLayout("abc \u05D0\u05D1\u05D2", layout =>
    {
        var areas = layout.HitTestTextRange(2, 4).OrderBy(area => area.X).ToList(); // c, space, alef, bet

        Assert.Equal(2, areas.Count);
        Assert.True(areas[0].Right < areas[1].Left);
    });

    private Task WithLayout(string text, Action<TextLayout> test, FlowDirection direction = FlowDirection.LeftToRight) => fixture.Runner.RunAsync(() =>
    {
        using var layout = new TextLayout(text, new Typeface(FontFamily.Default), Size, Brushes.Black, flowDirection: direction);
        test(layout);
        return Task.CompletedTask;
    });
}
