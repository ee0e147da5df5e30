namespace Engraver.Benchmarks.Motion.Parts;

/// <summary>Shapes like letters, one unit high.</summary>
internal static class Letters
{
    private const double Quarter = 0.41421356237309503; // bulge of a quarter of a circle

    /// <summary>Each letter as closed outlines.</summary>
    public static IReadOnlyList<Outline[]> Outlined { get; } =
    [
        [Polygon(0.0, 0.0, 0.55, 0.0, 0.55, 0.15, 0.17, 0.15, 0.17, 0.43, 0.48, 0.43, 0.48, 0.57, 0.17, 0.57, 0.17, 0.85, 0.55, 0.85, 0.55, 1.0, 0.0, 1.0)],
        [Polygon(0.0, 0.0, 0.5, 0.0, 0.5, 0.15, 0.17, 0.15, 0.17, 1.0, 0.0, 1.0)],
        [Polygon(0.22, 0.0, 0.39, 0.0, 0.39, 0.85, 0.61, 0.85, 0.61, 1.0, 0.0, 1.0, 0.0, 0.85, 0.22, 0.85)],
        [Polygon(0.0, 0.0, 0.17, 0.0, 0.26, 0.28, 0.49, 0.28, 0.58, 0.0, 0.75, 0.0, 0.45, 1.0, 0.3, 1.0), Polygon(0.3, 0.42, 0.45, 0.42, 0.375, 0.72)],
        [Polygon(0.0, 0.0, 0.17, 0.0, 0.17, 0.7, 0.5, 0.0, 0.67, 0.0, 0.67, 1.0, 0.5, 1.0, 0.5, 0.3, 0.17, 1.0, 0.0, 1.0)],
        [
            Outline.Closed((0.0, 0.0, 0.0), (0.2, 0.0, Quarter), (0.7, 0.5, Quarter), (0.2, 1.0, 0.0), (0.0, 1.0, 0.0)),
            Outline.Closed((0.17, 0.15, 0.0), (0.2, 0.15, Quarter), (0.53, 0.5, Quarter), (0.2, 0.85, 0.0), (0.17, 0.85, 0.0)),
        ],
        [Outline.Circle(0.5, 0.5, 0.5), Outline.Closed((0.17, 0.5, 0.9), (0.83, 0.5, 0.9))],
        [
            Outline.Closed((0.0, 0.0, 0.0), (0.17, 0.0, 0.0), (0.17, 0.42, 0.0), (0.35, 0.42, 1.0), (0.35, 1.0, 0.0), (0.0, 1.0, 0.0)),
            Outline.Closed((0.17, 0.57, 0.0), (0.35, 0.57, 1.0), (0.35, 0.85, 0.0), (0.17, 0.85, 0.0)),
        ],
        [
            Outline.Closed(
                (0.0, 1.0, 0.0), (0.0, 0.3, Quarter), (0.3, 0.0, 0.0), (0.4, 0.0, Quarter), (0.7, 0.3, 0.0), (0.7, 1.0, 0.0),
                (0.53, 1.0, 0.0), (0.53, 0.3, -Quarter), (0.4, 0.15, 0.0), (0.3, 0.15, -Quarter), (0.17, 0.3, 0.0), (0.17, 1.0, 0.0)),
        ],
        [
            Outline.Closed(
                (0.6, 0.8, 0.9), (0.05, 0.7, 0.35), (0.3, 0.45, -0.6), (0.3, 0.15, -0.3), (0.12, 0.3, 0.0), (0.0, 0.22, 0.5),
                (0.55, 0.2, 0.5), (0.35, 0.58, -0.6), (0.3, 0.86, -0.3), (0.45, 0.74, 0.0)),
        ],
    ];

    /// <summary>Each letter as open strokes.</summary>
    public static IReadOnlyList<Outline[]> Single { get; } =
    [
        [Stroke(0.0, 0.0, 0.3, 1.0, 0.6, 0.0), Stroke(0.12, 0.4, 0.48, 0.4)],
        [Stroke(0.0, 0.0, 0.0, 1.0, 0.3, 0.4, 0.6, 1.0, 0.6, 0.0)],
        [Stroke(0.0, 0.0, 0.0, 1.0, 0.6, 0.0, 0.6, 1.0)],
        [Stroke(0.0, 1.0, 0.2, 0.0, 0.4, 0.7, 0.6, 0.0, 0.8, 1.0)],
        [Stroke(0.0, 1.0, 0.6, 1.0, 0.0, 0.0, 0.6, 0.0)],
        [Stroke(0.6, 1.0, 0.0, 0.4), Stroke(0.0, 0.0, 0.0, 1.0), Stroke(0.15, 0.55, 0.6, 0.0)],
        [Stroke(0.6, 1.0, 0.0, 1.0, 0.0, 0.5, 0.45, 0.5, 0.0, 0.5, 0.0, 0.0, 0.6, 0.0)],
        [
            Outline.Open(
                (0.0, 0.8, -Quarter), (0.2, 1.0, 0.0), (0.3, 1.0, -1.0), (0.3, 0.5, 0.0), (0.2, 0.5, 0.0), (0.3, 0.5, -1.0),
                (0.3, 0.0, 0.0), (0.2, 0.0, -Quarter), (0.0, 0.2, 0.0)),
        ],
        [
            Outline.Open(
                (0.6, 0.8, Quarter), (0.4, 1.0, 0.0), (0.25, 1.0, 1.0), (0.25, 0.5, 0.0), (0.35, 0.5, -1.0), (0.35, 0.0, 0.0),
                (0.2, 0.0, -Quarter), (0.0, 0.2, 0.0)),
        ],
        [
            Outline.Open(
                (0.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.35, 1.0, -1.0), (0.35, 0.5, 0.0), (0.0, 0.5, 0.0), (0.3, 0.5, 0.0),
                (0.6, 0.0, 0.0)),
        ],
    ];

    private static Outline Polygon(params double[] numbers) => new(Vertices(numbers), true);

    private static Outline Stroke(params double[] numbers) => new(Vertices(numbers), false);

    private static IReadOnlyList<(double X, double Y, double Bulge)> Vertices(double[] numbers) =>
        [.. numbers.Chunk(2).Select(pair => (pair[0], pair[1], 0.0))];
}
