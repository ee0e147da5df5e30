using System.Text.Json.Serialization;

namespace Engraver.Workbench.Machines;

/// <summary>Where the last run of a drawing on a controller had the drawing's zero.</summary>
/// <param name="Controller">Where the controller is reached.</param>
/// <param name="Drawing">Its file, with the whole path.</param>
/// <param name="FrameX">Controller counts of axis A at the drawing's zero.</param>
/// <param name="FrameY">The same of axis B.</param>
/// <param name="At">When that run began.</param>
public sealed record RunStart(string Controller, string Drawing, int FrameX, int FrameY, DateTimeOffset At);

[JsonSourceGenerationOptions(PropertyNamingPolicy = JsonKnownNamingPolicy.CamelCase)]
[JsonSerializable(typeof(RunStart))]
internal sealed partial class RunStartJson : JsonSerializerContext;
