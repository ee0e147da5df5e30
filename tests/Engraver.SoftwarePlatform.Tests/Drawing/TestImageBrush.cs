using Avalonia;
using Avalonia.Media;

namespace Engraver.SoftwarePlatform.Tests.Drawing;

/// <summary>An image brush that works without an application.</summary>
internal sealed class TestImageBrush(TestImage image) : IImageBrush
{
    public IImageBrushSource? Source => image;

    public AlignmentX AlignmentX { get; init; } = AlignmentX.Center;

    public AlignmentY AlignmentY { get; init; } = AlignmentY.Center;

    public RelativeRect DestinationRect { get; init; } = RelativeRect.Fill;

    public RelativeRect SourceRect { get; init; } = RelativeRect.Fill;

    public Stretch Stretch { get; init; } = Stretch.Fill;

    public TileMode TileMode { get; init; } = TileMode.None;

    public double Opacity { get; init; } = 1;

    public ITransform? Transform { get; init; }

    public RelativePoint TransformOrigin { get; init; }
}
