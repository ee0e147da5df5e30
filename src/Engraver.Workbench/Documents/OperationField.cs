namespace Engraver.Workbench.Documents;

/// <summary>A field of an operation.</summary>
/// <param name="Name">As files write it.</param>
/// <param name="Value">As it is typed; empty where the operation does not state it.</param>
/// <param name="Choices">The possible values, where they are a fixed set; otherwise empty.</param>
public sealed record OperationField(string Name, string Value, IReadOnlyList<string> Choices);
