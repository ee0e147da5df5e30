using Avalonia;
using Avalonia.Media;
using Avalonia.Media.Immutable;

namespace Engraver.SoftwarePlatform.Tests.Drawing;

public class GradientTests
{
    [Fact]
    public void A_linear_gradient_has_its_mean_in_the_middle()
    {
        using var picture = Filled(Linear((Colors.Black, 0), (Colors.White, 1)), 100, 4);

        Near.Equal(Color.FromRgb(1, 1, 1), picture.Color(0, 0));
        Near.Equal(Color.FromRgb(128, 128, 128), picture.Color(50, 2));
        Near.Equal(Color.FromRgb(254, 254, 254), picture.Color(99, 3));
    }

    [Theory]
    [InlineData(GradientSpreadMethod.Pad, 255)]
    [InlineData(GradientSpreadMethod.Repeat, 51)]
    [InlineData(GradientSpreadMethod.Reflect, 204)]
    public void Outside_of_its_ends_a_gradient_goes_on_as_its_spread_method_says(GradientSpreadMethod spread, byte expected)
    {
        // 50 long; the point at 60 is 0.2 beyond the end.
        var brush = new ImmutableLinearGradientBrush(
            Stops((Colors.Black, 0), (Colors.White, 1)), 1, null, null, spread, new RelativePoint(0, 0, RelativeUnit.Absolute), new RelativePoint(50, 0, RelativeUnit.Absolute));
        using var picture = Filled(brush, 100, 2);

        Near.Equal(Color.FromRgb(expected, expected, expected), picture.Color(60, 0), 4);
    }

    [Fact]
    public void Stops_need_no_order_and_may_stand_at_the_same_place()
    {
        using var picture = Filled(Linear((Colors.Blue, 1), (Colors.Red, 0), (Colors.Red, 0.5), (Colors.Blue, 0.5)), 100, 2);

        Near.Equal(Colors.Red, picture.Color(49, 0));
        Near.Equal(Colors.Blue, picture.Color(51, 0));
    }

    [Fact]
    public void A_radial_gradient_is_equal_at_equal_distances()
    {
        var brush = new ImmutableRadialGradientBrush(
            Stops((Colors.White, 0), (Colors.Black, 1)), 1, null, null, GradientSpreadMethod.Pad, RelativePoint.Center, RelativePoint.Center, RelativeScalar.Middle, RelativeScalar.Middle);
        using var picture = Filled(brush, 100, 60);

        Near.Equal(Colors.White, picture.Color(50, 30), 6);
        Near.Equal(Color.FromRgb(127, 127, 127), picture.Color(75, 30), 4);
        Near.Equal(picture.Color(75, 30), picture.Color(50, 45), 6);
        Near.Equal(Colors.Black, picture.Color(0, 0));
    }

    [Fact]
    public void The_focus_of_a_radial_gradient_is_its_start()
    {
        var brush = new ImmutableRadialGradientBrush(
            Stops((Colors.White, 0), (Colors.Black, 1)), 1, null, null, GradientSpreadMethod.Pad, RelativePoint.Center, new RelativePoint(0.25, 0.5, RelativeUnit.Relative), RelativeScalar.Middle, RelativeScalar.Middle);
        using var picture = Filled(brush, 100, 100);

        Near.Equal(Colors.White, picture.Color(25, 50), 8);
        // Halfway from the focus at 25 to the border at 100.
        Near.Equal(Color.FromRgb(127, 127, 127), picture.Color(62, 50), 5);
        Near.Equal(Color.FromRgb(127, 127, 127), picture.Color(12, 50), 12);
    }

    [Fact]
    public void A_conic_gradient_starts_upwards_and_turns_clockwise()
    {
        var brush = new ImmutableConicGradientBrush(Stops((Colors.Black, 0), (Colors.White, 1)), 1, null, null, GradientSpreadMethod.Pad, RelativePoint.Center, 0);
        using var picture = Filled(brush, 100, 100);

        Near.Equal(Color.FromRgb(64, 64, 64), picture.Color(90, 50), 3);
        Near.Equal(Color.FromRgb(127, 127, 127), picture.Color(50, 90), 3);
        Near.Equal(Color.FromRgb(191, 191, 191), picture.Color(10, 50), 3);
    }

    [Fact]
    public void A_brush_transform_turns_around_its_origin()
    {
        var turned = new ImmutableLinearGradientBrush(
            Stops((Colors.Black, 0), (Colors.White, 1)), 1, new ImmutableTransform(Matrix.CreateRotation(Math.PI / 2)), RelativePoint.Center, GradientSpreadMethod.Pad, RelativePoint.TopLeft, new RelativePoint(1, 0, RelativeUnit.Relative));
        using var picture = Filled(turned, 100, 100);

        Near.Equal(picture.Color(10, 30), picture.Color(90, 30));
        Near.Equal(Color.FromRgb(76, 76, 76), picture.Color(50, 30), 4);
    }

    [Fact]
    public void A_gradient_of_opacity_is_premultiplied()
    {
        using var picture = Filled(Linear((Colors.White, 0), (Color.FromArgb(0, 255, 255, 255), 1)), 100, 2, Colors.Red);

        Near.Equal(Color.FromRgb(255, 127, 127), picture.Color(50, 0), 3);
    }

    internal static ImmutableLinearGradientBrush Linear(params (Color Color, double Offset)[] stops) =>
        new(Stops(stops), 1, null, null, GradientSpreadMethod.Pad, RelativePoint.TopLeft, new RelativePoint(1, 0, RelativeUnit.Relative));

    private static List<ImmutableGradientStop> Stops(params (Color Color, double Offset)[] stops) => [.. stops.Select(stop => new ImmutableGradientStop(stop.Offset, stop.Color))];

    private static Picture Filled(IBrush brush, int width, int height, Color? background = null) =>
        new Picture(width, height, background).Draw(c => c.DrawRectangle(brush, null, new RoundedRect(new Rect(0, 0, width, height))));
}
