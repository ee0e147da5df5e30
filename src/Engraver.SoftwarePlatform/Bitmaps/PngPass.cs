namespace Engraver.SoftwarePlatform.Bitmaps;

/// <summary>One pass over the image: its pixels stand at every <paramref name="StepX"/>th column and <paramref name="StepY"/>th row.</summary>
internal readonly record struct PngPass(int StartX, int StartY, int StepX, int StepY)
{
    private static readonly PngPass[] s_whole = [new(0, 0, 1, 1)];

    private static readonly PngPass[] s_adam7 =
    [
        new(0, 0, 8, 8), new(4, 0, 8, 8), new(0, 4, 4, 8), new(2, 0, 4, 4), new(0, 2, 2, 4), new(1, 0, 2, 2), new(0, 1, 1, 2),
    ];

    public int Columns(int width) => (width - StartX + StepX - 1) / StepX;

    public int Rows(int height) => (height - StartY + StepY - 1) / StepY;

    public static IReadOnlyList<PngPass> Of(bool isInterlaced) => isInterlaced ? s_adam7 : s_whole;
}
