"""Products with weights of bytes are those of the weights themselves, nearly, and each row's own."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

from intent_engine.speech.acoustic import block_products
from intent_engine.speech.acoustic.graph_writer import BLOCK, GraphWriter, as_blocks, as_bytes
from intent_engine.speech.acoustic.onnx_sessions import load_graph

WIDTH, OUTPUTS = 3 * BLOCK + 11, 7
numbers = st.floats(-100, 100, width=32)


def product(weights: np.ndarray, *, blocks: bool):
    graph = GraphWriter({"it/weight": weights, "it/bias": np.ones(len(weights), np.float32)}, blocks=blocks)
    graph.op("Identity", graph.linear("rows", "it"), name="product")
    session = load_graph(graph.written({"rows": ("n", weights.shape[1])}, ["product"]))
    return lambda rows: session.run(None, {"rows": rows})[0]


@pytest.mark.parametrize("blocks", [False, True])
def test_a_product_is_nearly_that_of_the_numbers(blocks):
    if blocks and not block_products.blocks_are_quick():
        pytest.skip("no products by blocks on this machine")
    rng = np.random.default_rng(0)
    weights, rows = (rng.normal(0, 1, (count, WIDTH)).astype(np.float32) for count in (OUTPUTS, 20))
    multiplied = product(weights, blocks=blocks)
    found = multiplied(rows)
    assert np.abs(found - (rows @ weights.T + 1)).max() < 0.02 * np.abs(found).max()
    for count in (1, 3, 20):
        assert np.allclose(multiplied(rows[:count]), found[:count], atol=1e-4), "whatever is asked about beside it"


def test_by_blocks_it_is_nearer():
    """Where a few numbers are large, as in what layers think, they take the rest of their row along."""
    if not block_products.blocks_are_quick():
        pytest.skip("no products by blocks on this machine")
    rng = np.random.default_rng(1)
    weights, rows = (rng.normal(0, 1, (count, WIDTH)).astype(np.float32) for count in (50, 50))
    rows[:, :3] *= 30
    right = rows @ weights.T + 1
    by_rows, by_blocks = (np.abs(product(weights, blocks=blocks)(rows) - right).mean() for blocks in (False, True))
    assert by_blocks < 0.7 * by_rows


@given(rows=arrays.arrays(np.float32, st.tuples(st.integers(1, 5), st.integers(1, 3 * BLOCK)), elements=numbers))
def test_bytes_are_the_numbers_again_by_their_scales(rows):
    small, scales = as_bytes(rows)
    assert np.abs(small * scales - rows).max() <= scales.max() / 2 + 1e-6
    around, each = as_blocks(rows)
    again = ((around.astype(np.float32) - 128) * each[..., np.newaxis]).reshape(len(rows), -1)
    assert np.abs(again[:, : rows.shape[1]] - rows).max() <= each.max() / 2 + 1e-6
    assert not again[:, rows.shape[1] :].any()


# -- whether to -----------------------------------------------------------------------------------------------------


@pytest.fixture
def asked_anew():
    block_products.blocks_are_quick.cache_clear()
    yield block_products.blocks_are_quick
    block_products.blocks_are_quick.cache_clear()


@pytest.mark.parametrize(
    ("told", "quick"),
    [
        ("flags\t\t: fpu avx2 avx512f avx512_vnni\n", True),
        ("processor: 0\nflags : fpu avx_vnni avx2\n", True),
        ("flags\t\t: fpu avx2\nvmx flags\t: avx512_vnni\n", False),
        ("Features\t: asimd asimddp\n", False),
        ("", False),
        (None, False),
    ],
)
def test_it_is_for_processors_that_sum_up_bytes(monkeypatch, tmp_path, asked_anew, told, quick):
    file = tmp_path / "cpuinfo"
    if told is not None:
        file.write_text(told)
    monkeypatch.setattr(block_products, "PROCESSOR", file)
    monkeypatch.setattr(block_products, "_exact", lambda: True)
    assert asked_anew() is quick


def test_not_where_onnx_runtime_cannot(monkeypatch, asked_anew):
    def refuses(_graph):
        raise RuntimeError("MatMulNBits is not a registered function/op")

    monkeypatch.setattr(block_products, "_sums_bytes", lambda: True)
    monkeypatch.setattr(block_products, "load_graph", refuses)
    assert asked_anew() is False


@pytest.mark.parametrize("spoilt", [0.99, 1.01])
def test_nor_where_it_sums_up_otherwise(monkeypatch, asked_anew, spoilt):
    class Session:
        def __init__(self, graph):
            self.session = load_graph(graph)

        def run(self, names, given):
            return [one * spoilt for one in self.session.run(names, given)]

    monkeypatch.setattr(block_products, "_sums_bytes", lambda: True)
    monkeypatch.setattr(block_products, "load_graph", Session)
    assert asked_anew() is False
